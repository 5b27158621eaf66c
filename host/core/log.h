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

  Verbosity verbosity() const { return verbosity_; }
  void problem(const std::string& text) const;  ///< an error or a bad result, e.g. bad samples; always shown
  void warning(const std::string& text) const;  ///< hidden by --quiet
  void note(const std::string& text) const;     ///< hidden by --quiet
  void detail(const std::string& text) const;   ///< shown by --verbose only

 private:
  std::ostream& sink_;
  Verbosity verbosity_;
};

}  // namespace candela
