// Writes text to a file or to stdout.
#include "host/cli/text_output.h"

#include <iostream>
#include <span>

#include "host/core/atomic_file.h"

namespace candela::cli {

void writeText(const std::string& target, const std::string& text) {
  if (target.empty()) return;
  if (target == "-") {
    std::cout << text << std::flush;
    return;
  }
  writeFileAtomically(target, std::as_bytes(std::span(text)));
}

}  // namespace candela::cli
