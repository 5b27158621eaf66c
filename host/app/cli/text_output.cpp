// Writes text to a file, to stdout or to stderr.
#include "host/app/cli/text_output.h"

#include <algorithm>
#include <iostream>

#include "host/base/atomic_file.h"

namespace candela::cli {

bool wantsText(const GeneralArguments& arguments, std::initializer_list<std::string_view> reports) {
  return !arguments.quiet && std::ranges::find(reports, "-") == reports.end();
}

std::ostream& textStream(std::span<const std::filesystem::path> images) {
  return std::ranges::any_of(images, image::isStandardOutput) ? std::cerr : std::cout;
}

void writeText(const std::string& target, const std::string& text) {
  if (target.empty()) return;
  if (target == "-") {
    std::cout << text << std::flush;
    return;
  }
  writeFileAtomically(target, std::as_bytes(std::span(text)));
}

}  // namespace candela::cli
