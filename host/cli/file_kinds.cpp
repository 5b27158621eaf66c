// The extensions of the formats that are read or written.
#include "host/cli/file_kinds.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "host/core/errors.h"

namespace candela::cli {
namespace {

constexpr std::array<std::string_view, 4> kScenes{".p3f", ".nff", ".gltf", ".glb"};
constexpr std::array<std::string_view, 6> kImages{".png", ".jpg", ".jpeg", ".hdr", ".pfm", ".exr"};
constexpr std::array<std::string_view, 9> kOthers{".html", ".htm", ".json", ".pdf", ".svg",
                                                  ".md",   ".csv", ".xml",  ".txt"};

template <class Extensions>
bool has(const Extensions& extensions, std::string_view extension) {
  return std::ranges::find(extensions, extension) != std::ranges::end(extensions);
}

}  // namespace

std::string extensionOf(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c | 0x20) : c; });
  return extension;
}

bool isSceneName(const std::filesystem::path& file) { return has(kScenes, extensionOf(file)); }

bool isImageName(const std::filesystem::path& file) { return has(kImages, extensionOf(file)); }

void refuseOtherFormat(const std::filesystem::path& file, const std::vector<std::string_view>& extensions,
                       const std::string& what) {
  const std::string extension = extensionOf(file);
  const bool isKnown = isSceneName(file) || isImageName(file) || has(kOthers, extension);
  if (!isKnown || has(extensions, extension)) return;
  std::filesystem::path better = file;
  better.replace_extension(extensions.front());
  throw UsageError(fmt::format("{}: {}; name it {}", file.string(), what, better.string()));
}

}  // namespace candela::cli
