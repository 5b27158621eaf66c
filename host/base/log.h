// Messages to the user on stderr, filtered by verbosity.
#pragma once
#include <iosfwd>
#include <string>

namespace candela {

enum class Verbosity { quiet, normal, verbose };

/// Writes to `sink` (stderr), each line after the name of the program. A message appears if the verbosity is at least
/// its own; a `problem` always appears. Control characters are replaced by question marks.
class Log {
 public:
  Log(std::ostream& sink, Verbosity verbosity) : sink_(sink), verbosity_(verbosity) {}
  virtual ~Log() = default;
  Log(const Log&) = delete;
  Log& operator=(const Log&) = delete;

  Verbosity verbosity() const { return verbosity_; }
  virtual void problem(const std::string& text) const;  ///< an error or a bad result, e.g. bad samples; always shown
  virtual void warning(const std::string& text) const;  ///< hidden by --quiet
  virtual void note(const std::string& text) const;     ///< hidden by --quiet
  virtual void detail(const std::string& text) const;   ///< shown by --verbose only

 private:
  std::ostream& sink_;
  Verbosity verbosity_;
};

}  // namespace candela
