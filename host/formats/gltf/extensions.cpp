// Checks version and extensions.
#include "host/formats/gltf/extensions.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "host/base/quote.h"
#include "host/base/setting_words.h"
#include "host/formats/gltf/draco.h"
#include "host/formats/gltf/meshopt.h"

namespace candela::gltf {
namespace {

/// With metadata, which changes no picture.
constexpr std::array kComplete{"CANDELA_materials_conductor",
                               "EXT_mesh_gpu_instancing",
                               "EXT_texture_webp",
                               "KHR_animation_pointer",
                               "KHR_lights_punctual",
                               "KHR_materials_anisotropy",
                               "KHR_materials_clearcoat",
                               "KHR_materials_dispersion",
                               "KHR_materials_emissive_strength",
                               "KHR_materials_ior",
                               "KHR_materials_iridescence",
                               "KHR_materials_pbrSpecularGlossiness",
                               "KHR_materials_sheen",
                               "KHR_materials_specular",
                               "KHR_materials_transmission",
                               "KHR_materials_volume",
                               "KHR_mesh_quantization",
                               "KHR_node_visibility",
                               "KHR_texture_transform",
                               "KHR_xmp",
                               "KHR_xmp_json_ld"};
constexpr std::array kPartly{"KHR_materials_unlit", "KHR_materials_variants"};

bool isMeshopt(std::string_view extension) {
  return extension == "EXT_meshopt_compression" || extension == "KHR_meshopt_compression";
}

void checkVersion(const Value& root) {
  const Value version = root.require("asset").require("version");
  if (!version.text().starts_with("2.")) {
    version.fail(fmt::format("glTF {}; only version 2 is read", scene::quote(version.text())));
  }
  const std::optional<Value> least = root.require("asset").find("minVersion");
  if (least && least->text() != "2.0") {
    least->fail(fmt::format("the file needs glTF {}; only 2.0 is read", scene::quote(least->text())));
  }
}

std::string reasonFor(std::string_view extension) {
  if (extension == "KHR_draco_mesh_compression") return "this program was built without Draco";
  if (isMeshopt(extension)) return "this program was built without meshoptimizer";
  return "it is not supported";
}

void refuse(const Value& name, bool lenient, scene::DiagnosticLog& log) {
  const std::string message = fmt::format("the file requires the extension {}; {}", scene::quote(name.text()),
                                          reasonFor(name.text()));
  const bool isCompression = name.text().ends_with("_compression");
  if (!lenient)
    name.fail(isCompression ? message
                            : fmt::format("{}, and {} reads the file without it", message, settingWords("lenient")));
  if (isCompression) name.fail(message);
  log.warn("required", {}, fmt::format("{}: {}, so that the picture may be wrong", name.pointer(), message));
}

void checkRequired(const Value& root, bool lenient, scene::DiagnosticLog& log) {
  const std::optional<Value> required = root.find("extensionsRequired");
  for (std::size_t i = 0; required && i < required->size(); ++i) {
    const Value name = (*required)[i];
    if (supportOf(name.text()) == Support::none) refuse(name, lenient, log);
  }
}

}  // namespace

Support supportOf(std::string_view extension) {
  if (extension == "KHR_draco_mesh_compression") return canDecodeDraco() ? Support::complete : Support::none;
  if (isMeshopt(extension) && !canDecodeMeshopt()) return Support::none;
  if (isMeshopt(extension)) return extension.starts_with("EXT_") ? Support::complete : Support::partly;
  if (std::ranges::count(kComplete, extension) > 0) return Support::complete;
  return std::ranges::count(kPartly, extension) > 0 ? Support::partly : Support::none;
}

UsedExtensions checkAsset(const Value& root, bool lenient, scene::DiagnosticLog& log) {
  checkVersion(root);
  checkRequired(root, lenient, log);
  UsedExtensions used;
  const std::optional<Value> list = root.find("extensionsUsed");
  for (std::size_t i = 0; list && i < list->size(); ++i) {
    const std::string name = (*list)[i].text();
    const std::string quoted = scene::quote(name);
    const std::string shown = quoted.substr(1, quoted.size() - 2);
    used.all.push_back(shown);
    if (supportOf(name) == Support::partly) used.partly.push_back(shown);
    if (supportOf(name) == Support::none) used.unsupported.push_back(shown);
  }
  if (!used.unsupported.empty()) {
    log.warn("extension", {},
             fmt::format("extensions that are not supported are ignored: {}", fmt::join(used.unsupported, ", ")));
  }
  return used;
}

}  // namespace candela::gltf
