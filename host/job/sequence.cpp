// Inserts numbers of frames into names of files.
#include "host/job/sequence.h"

#include <fmt/format.h>

#include <string>

namespace candela::job {

bool isFramePattern(const std::filesystem::path& file) {
  return file.filename().string().find('#') != std::string::npos;
}

std::filesystem::path frameFile(const std::filesystem::path& pattern, std::uint32_t frame) {
  std::string name = pattern.filename().string();
  const std::size_t last = name.rfind('#');
  if (last == std::string::npos) return pattern;
  const std::size_t before = name.find_last_not_of('#', last);
  const std::size_t first = before == std::string::npos ? 0 : before + 1;
  const std::size_t length = last - first + 1;
  name.replace(first, length, fmt::format("{:0{}}", frame, length));
  return pattern.parent_path() / name;
}

}  // namespace candela::job
