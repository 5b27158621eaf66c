// The loader of PLY: header, mesh, material, view and light.
#include "host/formats/ply/ply_loader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "host/base/errors.h"
#include "host/formats/loading/file_hash.h"
#include "host/formats/loading/model_scene.h"
#include "host/formats/loading/scene_builder.h"
#include "host/formats/ply/ply_header.h"
#include "host/formats/ply/ply_mesh.h"

namespace candela::ply {
namespace {

std::string wordsOf(Encoding encoding) {
  if (encoding == Encoding::ascii) return "ASCII";
  return encoding == Encoding::littleEndian ? "binary, little-endian" : "binary, big-endian";
}

/// Alpha of vertex colours makes a surface transparent.
scene::Material materialOf(const Contents& contents) {
  scene::Material material = scene::plainMaterial(!contents.mesh.colours.empty());
  if (contents.hasTransparency) material.opacity = scene::Opacity{};
  return material;
}

scene::LoadedScene loadPly(const scene::SceneFile& file, const scene::LoadOptions& options) {
  const std::shared_future<std::uint64_t> hash = scene::startHash(file.bytes);
  const Header header = readHeader(file);
  scene::DiagnosticLog log(file.name);
  Contents contents = readContents(file, header, options.lenient, log);
  if (!contents.omissions.empty()) {
    log.warn("omissions", {}, fmt::format("not rendered: {}", fmt::join(contents.omissions, ", ")));
  }
  scene::LoadedScene loaded{.scene = {}, .counts = std::move(contents.counts), .warnings = {}};
  loaded.facts = {{"encoding", wordsOf(header.encoding)}};
  loaded.scene.materials.push_back(materialOf(contents));
  scene::addMesh(loaded.scene, std::move(contents.mesh), 0);
  for (auto& fact : scene::completeModel(loaded.scene, options, log)) loaded.facts.push_back(std::move(fact));
  if (!contents.unused.empty()) {
    loaded.facts.emplace_back("not used", fmt::format("{}", fmt::join(contents.unused, ", ")));
  }
  loaded.scene.name = std::filesystem::path(file.name).filename().string();
  loaded.scene.hash = hash.get();
  loaded.warnings = log.warnings();
  return loaded;
}

std::unique_ptr<scene::SceneReader> openPly(const scene::SceneFile& file, const scene::LoadOptions& options, bool) {
  return scene::readStill(file, options, loadPly);
}

}  // namespace

scene::Loader plyLoader() { return {"PLY", {".ply"}, looksLikePly, openPly}; }

}  // namespace candela::ply
