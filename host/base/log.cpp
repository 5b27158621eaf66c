// Writes lines to stderr according to the verbosity.
#include "host/base/log.h"

#include <ostream>
#include <sstream>
#include <string>

namespace candela {
namespace {

// Names of files may contain any bytes, and a terminal would obey control characters.
std::string withoutControls(std::string line) {
  for (char& c : line) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte < 0x20 && c != '\t') || byte == 0x7f) c = '?';
  }
  return line;
}

}  // namespace

void Log::problem(const std::string& text) const {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) sink_ << "candela: " << withoutControls(line) << std::endl;
}

void Log::warning(const std::string& text) const {
  if (verbosity_ != Verbosity::quiet) problem("warning: " + text);
}

void Log::note(const std::string& text) const {
  if (verbosity_ != Verbosity::quiet) problem(text);
}

void Log::detail(const std::string& text) const {
  if (verbosity_ == Verbosity::verbose) problem(text);
}

}  // namespace candela
