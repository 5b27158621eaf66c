// Writes lines to stderr according to the verbosity.
#include "host/core/log.h"

#include <ostream>
#include <sstream>

namespace candela {

void Log::problem(const std::string& text) const {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) sink_ << "candela: " << line << std::endl;
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
