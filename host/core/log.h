// What the program says to the person who runs it, and how much of it.
#pragma once
#include <iosfwd>
#include <string>

namespace candela {

enum class Verbosity { quiet, normal, verbose };

/// Writes to `sink` (stderr), each line after the program's name. A text is shown from its own verbosity on; `problem`
/// is always shown.
class Log {
 public:
  Log(std::ostream& sink, Verbosity verbosity) : sink_(sink), verbosity_(verbosity) {}

  Verbosity verbosity() const { return verbosity_; }
  void problem(const std::string& text) const;  ///< must be seen, e.g. bad samples
  void warning(const std::string& text) const;  ///< hidden by --quiet
  void note(const std::string& text) const;     ///< hidden by --quiet
  void detail(const std::string& text) const;   ///< shown by --verbose only

 private:
  std::ostream& sink_;
  Verbosity verbosity_;
};

}  // namespace candela
