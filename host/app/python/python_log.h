// The messages of a call, as Python warnings and logging records.
#pragma once
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "host/base/log.h"

namespace candela::python {

/// Collects messages from any thread, until the thread that holds the GIL passes them on.
class PythonLog final : public Log {
 public:
  PythonLog();

  void problem(const std::string& text) const override { add("problem", text); }
  void warning(const std::string& text) const override { add("warning", text); }
  void note(const std::string& text) const override { add("note", text); }
  void detail(const std::string& text) const override { add("detail", text); }

  /// Passes the messages so far to candela._messages. The caller holds the GIL. Throws the exception that a filter of
  /// warnings raises.
  void passOn();

 private:
  void add(const char* kind, const std::string& text) const;

  mutable std::mutex mutex_;
  mutable std::vector<std::pair<std::string, std::string>> messages_;
};

}  // namespace candela::python
