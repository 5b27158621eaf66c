// The choice among loaders.
#include "host/formats/loading/loader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "host/base/file_extension.h"

namespace candela::scene {
namespace {

std::string formatsOf(std::span<const Loader> loaders) {
  std::vector<std::string> formats;
  for (const Loader& loader : loaders) {
    formats.push_back(fmt::format("{} ({})", loader.name, fmt::join(loader.extensions, ", ")));
  }
  return fmt::format("{}", fmt::join(formats, ", "));
}

}  // namespace

const Loader& chooseLoader(std::span<const Loader> loaders, const SceneFile& file) {
  const auto byContent = std::ranges::find_if(loaders, [&](const Loader& l) { return l.recognises(file.bytes); });
  if (byContent != loaders.end()) return *byContent;
  const std::string extension = extensionOf(file.name);
  const auto reads = [&](const Loader& loader) { return std::ranges::count(loader.extensions, extension) > 0; };
  const auto byExtension = std::ranges::find_if(loaders, reads);
  if (byExtension != loaders.end()) return *byExtension;
  throw SceneError(
      {{file.name, 0, 0,
        fmt::format("unknown scene format: neither the content nor the extension is one of {}", formatsOf(loaders))}});
}

}  // namespace candela::scene
