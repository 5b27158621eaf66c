// Keeps objects from being used twice at once.
#pragma once
#include <atomic>
#include <string>

#include "host/base/errors.h"

namespace candela::python {

/// Marks an object as in use. Throws UsageError if it already is: by another thread, or by the call whose callback this
/// is.
class Claim {
 public:
  /// `object` is its name in the message: "the session".
  Claim(std::atomic<bool>& isBusy, const std::string& object) : isBusy_(isBusy) {
    if (isBusy_.exchange(true)) throw UsageError(object + " is in use");
  }
  ~Claim() { isBusy_.store(false); }
  Claim(const Claim&) = delete;
  Claim& operator=(const Claim&) = delete;

 private:
  std::atomic<bool>& isBusy_;
};

}  // namespace candela::python
