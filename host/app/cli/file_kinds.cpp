// Compares the extension of a file with those of known formats.
#include "host/app/cli/file_kinds.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "host/base/errors.h"
#include "host/base/file_extension.h"
#include "host/formats/load_scene.h"
#include "host/image/image.h"

namespace candela::cli {
namespace {

constexpr std::array<std::string_view, 9> kOthers{".html", ".htm", ".json", ".pdf", ".svg",
                                                  ".md",   ".csv", ".xml",  ".txt"};

template <class Extensions>
bool has(const Extensions& extensions, std::string_view extension) {
  return std::ranges::find(extensions, extension) != std::ranges::end(extensions);
}

}  // namespace

bool isSceneName(const std::filesystem::path& file) {
  return std::ranges::any_of(formats::allLoaders(), [extension = extensionOf(file)](const scene::Loader& loader) {
    return has(loader.extensions, extension);
  });
}

void refuseOtherFormat(const std::filesystem::path& file, const std::vector<std::string_view>& extensions,
                       const std::string& what) {
  const std::string extension = extensionOf(file);
  const bool isKnown = isSceneName(file) || image::hasImageExtension(file) || has(kOthers, extension);
  if (!isKnown || has(extensions, extension)) return;
  std::filesystem::path better = file;
  better.replace_extension(extensions.front());
  throw UsageError(fmt::format("{}: {}; name it {}", file.string(), what, better.string()));
}

}  // namespace candela::cli
