// The choice among loaders, and the reader of formats without animations.
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

class StillReader final : public SceneReader {
 public:
  StillReader(const SceneFile& file, const LoadOptions& options,
              LoadedScene (*load)(const SceneFile&, const LoadOptions&))
      : file_(file), options_(options), load_(load) {}

  LoadedScene at(std::optional<double> time) override {
    options_.time = time;
    return load_(file_, options_);
  }

 private:
  SceneFile file_;
  LoadOptions options_;
  LoadedScene (*load_)(const SceneFile&, const LoadOptions&);
};

}  // namespace

std::unique_ptr<SceneReader> readStill(const SceneFile& file, const LoadOptions& options,
                                       LoadedScene (*load)(const SceneFile&, const LoadOptions&)) {
  return std::make_unique<StillReader>(file, options, load);
}

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
