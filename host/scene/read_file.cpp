// Reads a whole file into memory.
#include "host/scene/read_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "host/core/errors.h"

namespace candela::scene {
namespace {

constexpr std::size_t kMaxFileSize = std::size_t{1} << 30;

}  // namespace

std::string readFile(const std::filesystem::path& path) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
  if (!file) throw FileError(fmt::format("{}: cannot open: {}", path.string(), std::strerror(errno)));
  std::string text;
  std::string block(1 << 20, '\0');
  while (const std::size_t count = std::fread(block.data(), 1, block.size(), file.get())) {
    text.append(block, 0, count);
    if (text.size() > kMaxFileSize) throw FileError(fmt::format("{}: larger than 1 GiB", path.string()));
  }
  if (std::ferror(file.get())) throw FileError(fmt::format("{}: cannot read: {}", path.string(), std::strerror(errno)));
  return text;
}

}  // namespace candela::scene
