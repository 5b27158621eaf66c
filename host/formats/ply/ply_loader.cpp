// The loader of PLY: header, mesh, material, view and light.
#include "host/formats/ply/ply_loader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>
#include <span>

#include "host/base/errors.h"
#include "host/base/hash.h"
#include "host/base/setting_words.h"
#include "host/formats/loading/file_hash.h"
#include "host/formats/loading/model_scene.h"
#include "host/formats/loading/path_guard.h"
#include "host/formats/loading/read_file.h"
#include "host/formats/loading/scene_builder.h"
#include "host/formats/loading/shrink_images.h"
#include "host/formats/ply/ply_header.h"
#include "host/formats/ply/ply_mesh.h"
#include "host/image/texels.h"

namespace candela::ply {
namespace {

std::string wordsOf(Encoding encoding) {
  if (encoding == Encoding::ascii) return "ASCII";
  return encoding == Encoding::littleEndian ? "binary, little-endian" : "binary, big-endian";
}

/// A scene while it is made.
struct Making {
  const scene::SceneFile& file;
  const scene::LoadOptions& options;
  scene::PathGuard guard;
  scene::DiagnosticLog log;
  scene::LoadedScene loaded{};
  std::uint64_t imageHash = 0;
};

/// Reads the image of a texture. Throws SceneError, or warns with LoadOptions::lenient, if it cannot be read.
std::optional<scene::TextureImage> readImage(const TextureFile& texture, Making& making) {
  const auto& [line, column] = texture.position;
  try {
    const std::filesystem::path path = making.file.folder / texture.name;
    making.guard.require(path);
    const std::string bytes = scene::readFile(path);
    image::Texels texels = image::decodeModelTexels(std::as_bytes(std::span(bytes)));
    making.imageHash = fnv1aOfText(bytes);
    return scene::TextureImage{texture.name, texels.width, texels.height, std::move(texels.rgba),
                               std::move(texels.deepRgba)};
  } catch (const FileError& error) {
    if (!making.options.lenient) {
      throw scene::SceneError({{making.file.name, line, column,
                                fmt::format("{}; {} leaves out a texture whose image cannot be read", error.what(),
                                            settingWords("lenient"))}});
    }
    making.log.warn("image", texture.position, fmt::format("{}; the texture is left out", error.what()));
    return std::nullopt;
  }
}

/// The image is the colour of the surface, with v from its bottom. Faces with coordinates of their own, or with several
/// images, are not rendered with them.
void addTexture(const Header& header, Contents& contents, Making& making) {
  const bool hasTexCoords = !contents.mesh.texCoords[0].empty();
  if (header.textures.empty() && hasTexCoords) contents.unused.insert("texture coordinates (the file names no image)");
  if (!header.textures.empty() && !hasTexCoords)
    contents.omissions.insert("TextureFile without coordinates of vertices");
  if (header.textures.size() > 1) contents.omissions.insert("TextureFile after the first");
  if (header.textures.empty() || !hasTexCoords) return;
  std::optional<scene::TextureImage> image = readImage(header.textures.front(), making);
  if (!image) return;
  scene::Scene& scene = making.loaded.scene;
  scene.images.push_back(std::move(*image));
  for (const std::string& sentence : scene::shrinkImages(scene.images)) making.log.warn("images", {}, sentence);
  scene::Material& material = scene.materials.front();
  material.diffuse->colour = glm::vec3(1);
  material.textures[static_cast<std::size_t>(scene::TextureSlot::baseColour)] = scene::TextureReference{
      .rowS = {1, 0, 0}, .rowT = {0, -1, 1}};
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
  Making making{file, options, scene::PathGuard(file.folder, options.allowedPaths), scene::DiagnosticLog(file.name)};
  Contents contents = readContents(file, header, {}, options.lenient, making.log);
  scene::LoadedScene& loaded = making.loaded;
  loaded.counts = std::move(contents.counts);
  loaded.facts = {{"encoding", wordsOf(header.encoding)}};
  loaded.scene.materials.push_back(materialOf(contents));
  addTexture(header, contents, making);
  if (!contents.omissions.empty()) {
    making.log.warn("omissions", {}, fmt::format("not rendered: {}", fmt::join(contents.omissions, ", ")));
  }
  scene::addMesh(loaded.scene, std::move(contents.mesh), 0);
  for (auto& fact : scene::completeModel(loaded.scene, options, making.log)) loaded.facts.push_back(std::move(fact));
  if (!contents.unused.empty()) {
    loaded.facts.emplace_back("not used", fmt::format("{}", fmt::join(contents.unused, ", ")));
  }
  loaded.scene.name = std::filesystem::path(file.name).filename().string();
  loaded.scene.hash = loaded.scene.images.empty()
                          ? hash.get()
                          : fnv1aOfText(fmt::format("image {:x}", making.imageHash), hash.get());
  loaded.warnings = making.log.warnings();
  loaded.files = making.guard.requiredPaths();
  return std::move(loaded);
}

std::unique_ptr<scene::SceneReader> openPly(const scene::SceneFile& file, const scene::LoadOptions& options, bool) {
  return scene::readStill(file, options, loadPly);
}

}  // namespace

scene::Loader plyLoader() { return {"PLY", {".ply"}, looksLikePly, openPly}; }

}  // namespace candela::ply
