// Lines on stderr, by verbosity.
#include "host/core/log.h"

#include <ostream>

namespace candela {

void Log::problem(const std::string& text) const { sink_ << "candela: " << text << std::endl; }

void Log::warning(const std::string& text) const {
  if (verbosity_ != Verbosity::quiet) sink_ << "candela: warning: " << text << std::endl;
}

void Log::note(const std::string& text) const {
  if (verbosity_ != Verbosity::quiet) sink_ << "candela: " << text << std::endl;
}

void Log::detail(const std::string& text) const {
  if (verbosity_ == Verbosity::verbose) sink_ << "candela: " << text << std::endl;
}

}  // namespace candela
