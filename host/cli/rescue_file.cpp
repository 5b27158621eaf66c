// Chooses the name.
#include "host/cli/rescue_file.h"

#include <fmt/format.h>

#include "host/image/image.h"

namespace candela::cli {

std::filesystem::path rescueFile(const Arguments& arguments) {
  constexpr int kMaxFiles = 100;
  if (arguments.outputs.empty()) return {};
  const std::filesystem::path& first = arguments.outputs.front();
  const std::filesystem::path output = image::isStandardOutput(first) ? "candela" : first;
  std::error_code error;
  if (std::filesystem::exists(output, error) && !std::filesystem::is_regular_file(output, error)) return {};
  for (int i = 1; i <= kMaxFiles; ++i) {
    std::filesystem::path file = output;
    file += i == 1 ? ".film.exr" : fmt::format(".film-{}.exr", i);
    if (!std::filesystem::exists(file, error)) return file;
  }
  return {};
}

}  // namespace candela::cli
