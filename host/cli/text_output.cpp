// Writes text to a file, to stdout or to stderr.
#include "host/cli/text_output.h"

#include <iostream>
#include <span>

#include "host/core/atomic_file.h"

namespace candela::cli {

std::ostream& textStream(const Arguments& arguments) { return arguments.writesImageToStdout() ? std::cerr : std::cout; }

void writeText(const std::string& target, const std::string& text) {
  if (target.empty()) return;
  if (target == "-") {
    std::cout << text << std::flush;
    return;
  }
  writeFileAtomically(target, std::as_bytes(std::span(text)));
}

}  // namespace candela::cli
