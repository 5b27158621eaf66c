// The properties that an animation may change, with their numbers of components and their ranges (glTF 2.0 Asset Object
// Model).
#include "host/formats/gltf/animation_pointer.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>

#include "host/base/quote.h"

namespace candela::gltf {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kAny = 0;  // components of weights, one for each morph target

struct Property {
  std::string_view path;  ///< with * for each index
  std::size_t components = 1;
  double min = -kInfinity;
  double max = kInfinity;
};

constexpr std::array kProperties{
    Property{"/cameras/*/orthographic/xmag"},
    Property{"/cameras/*/orthographic/ymag"},
    Property{"/cameras/*/orthographic/zfar"},
    Property{"/cameras/*/orthographic/znear"},
    Property{"/cameras/*/perspective/aspectRatio"},
    Property{"/cameras/*/perspective/yfov"},
    Property{"/cameras/*/perspective/zfar"},
    Property{"/cameras/*/perspective/znear"},
    Property{"/extensions/KHR_lights_punctual/lights/*/color", 3, 0},
    Property{"/extensions/KHR_lights_punctual/lights/*/intensity", 1, 0},
    Property{"/extensions/KHR_lights_punctual/lights/*/range", 1, 0},
    Property{"/extensions/KHR_lights_punctual/lights/*/spot/innerConeAngle", 1, 0},
    Property{"/extensions/KHR_lights_punctual/lights/*/spot/outerConeAngle"},
    Property{"/materials/*/alphaCutoff", 1, 0},
    Property{"/materials/*/emissiveFactor", 3, 0},
    Property{"/materials/*/extensions/KHR_materials_anisotropy/anisotropyRotation"},
    Property{"/materials/*/extensions/KHR_materials_anisotropy/anisotropyStrength", 1, 0, 1},
    Property{"/materials/*/extensions/KHR_materials_clearcoat/clearcoatFactor", 1, 0, 1},
    Property{"/materials/*/extensions/KHR_materials_clearcoat/clearcoatNormalTexture/scale"},
    Property{"/materials/*/extensions/KHR_materials_clearcoat/clearcoatRoughnessFactor", 1, 0, 1},
    Property{"/materials/*/extensions/KHR_materials_dispersion/dispersion", 1, 0},
    Property{"/materials/*/extensions/KHR_materials_emissive_strength/emissiveStrength", 1, 0},
    Property{"/materials/*/extensions/KHR_materials_ior/ior", 1, 1},
    Property{"/materials/*/extensions/KHR_materials_iridescence/iridescenceFactor", 1, 0, 1},
    Property{"/materials/*/extensions/KHR_materials_iridescence/iridescenceIor", 1, 1},
    Property{"/materials/*/extensions/KHR_materials_iridescence/iridescenceThicknessMaximum", 1, 0},
    Property{"/materials/*/extensions/KHR_materials_iridescence/iridescenceThicknessMinimum", 1, 0},
    Property{"/materials/*/extensions/KHR_materials_sheen/sheenColorFactor", 3, 0, 1},
    Property{"/materials/*/extensions/KHR_materials_sheen/sheenRoughnessFactor", 1, 0, 1},
    Property{"/materials/*/extensions/KHR_materials_specular/specularColorFactor", 3, 0},
    Property{"/materials/*/extensions/KHR_materials_specular/specularFactor", 1, 0, 1},
    Property{"/materials/*/extensions/KHR_materials_transmission/transmissionFactor", 1, 0, 1},
    Property{"/materials/*/extensions/KHR_materials_volume/attenuationColor", 3, 0, 1},
    Property{"/materials/*/extensions/KHR_materials_volume/attenuationDistance", 1, 0},
    Property{"/materials/*/extensions/KHR_materials_volume/thicknessFactor", 1, 0},
    Property{"/materials/*/normalTexture/scale"},
    Property{"/materials/*/occlusionTexture/strength", 1, 0, 1},
    Property{"/materials/*/pbrMetallicRoughness/baseColorFactor", 4, 0, 1},
    Property{"/materials/*/pbrMetallicRoughness/metallicFactor", 1, 0, 1},
    Property{"/materials/*/pbrMetallicRoughness/roughnessFactor", 1, 0, 1},
    Property{"/meshes/*/weights", kAny},
    Property{"/nodes/*/extensions/KHR_node_visibility/visible", 1, 0, 1},
    Property{"/nodes/*/rotation", 4},
    Property{"/nodes/*/scale", 3},
    Property{"/nodes/*/translation", 3},
    Property{"/nodes/*/weights", kAny}};

/// These belong to any texture of a material, below its KHR_texture_transform.
constexpr std::array kTransformProperties{Property{"offset", 2}, Property{"rotation"}, Property{"scale", 2}};
constexpr std::string_view kTransform = "/extensions/KHR_texture_transform/";

bool isIndex(std::string_view word) {
  constexpr std::size_t kMaxDigits = 9;
  return !word.empty() && word.size() <= kMaxDigits &&
         std::ranges::all_of(word, [](char c) { return c >= '0' && c <= '9'; });
}

/// Replaces each index of a pointer by an asterisk.
std::string patternOf(std::string_view pointer) {
  std::string pattern;
  while (!pointer.empty()) {
    const std::size_t end = std::min(pointer.find('/', 1), pointer.size());
    const std::string_view word = pointer.substr(1, end - 1);
    pattern += "/";
    pattern += isIndex(word) ? "*" : word;
    pointer.remove_prefix(end);
  }
  return pattern;
}

template <std::size_t N>
const Property* find(const std::array<Property, N>& properties, std::string_view path) {
  const auto found = std::ranges::find(properties, path, &Property::path);
  return found == properties.end() ? nullptr : &*found;
}

/// Returns the property to which a JSON pointer leads, in a file that has it; null: none that an animation may change.
const Property* propertyAt(const std::string& pointer) {
  constexpr std::string_view
      kNameCharacters = "/_0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";  // of all properties: no
                                                                                             // pointer needs an escape
  if (!pointer.starts_with('/') || pointer.find_first_not_of(kNameCharacters) != std::string::npos) return nullptr;
  const std::string pattern = patternOf(pointer);
  const std::size_t transform = pattern.find(kTransform);
  if (!pattern.starts_with("/materials/*/") || transform == std::string::npos) return find(kProperties, pattern);
  return find(kTransformProperties, std::string_view(pattern).substr(transform + kTransform.size()));
}

bool exists(const std::string& pointer, const nlohmann::json& document) {
  return document.contains(nlohmann::json::json_pointer(pointer));
}

/// The object `path` that has the property, which only pbrMetallicRoughness need not be written in the file.
nlohmann::json& ownerAt(const std::string& path, const Value& pointer, nlohmann::json& document) {
  constexpr std::string_view kImplied = "/pbrMetallicRoughness";
  const bool isImplied = path.ends_with(kImplied) && exists(path.substr(0, path.size() - kImplied.size()), document);
  if (!isImplied && !exists(path, document)) {
    pointer.fail("the file has no object " + path + " that would have the property");
  }
  nlohmann::json& object = document[nlohmann::json::json_pointer(path)];
  if (!object.is_object() && !object.is_null()) pointer.fail(path + " is not an object");
  if (object.contains("matrix")) {
    pointer.fail("an animated node has a matrix instead of translation, rotation and scale");
  }
  return object;
}

}  // namespace

void setPointedProperty(const Value& target, const Value& sampler, double seconds, Accessors& accessors,
                        nlohmann::json& document) {
  const std::optional<Value> extension = extensionOf(target, "KHR_animation_pointer");
  if (!extension) target.fail("a channel with the path pointer lacks KHR_animation_pointer");
  const Value pointer = extension->require("pointer");
  const std::string& text = pointer.text();
  const Property* const property = propertyAt(text);
  if (property == nullptr) pointer.fail(scene::quote(text) + " is not a property that an animation may change");
  const std::size_t slash = text.rfind('/');
  nlohmann::json& owner = ownerAt(text.substr(0, slash), pointer, document);
  const std::size_t components = std::max<std::size_t>(property->components, 1);
  const Sampler frames = readSampler(sampler, components, accessors);
  if (property->components != kAny && frames.width != components) {
    sampler.require("output").fail("has more numbers than the property " + text);
  }
  std::vector<double> values = evaluate(frames, seconds, property->path == "/nodes/*/rotation");
  for (double& value : values) value = std::clamp(value, property->min, property->max);
  nlohmann::json& member = owner[text.substr(slash + 1)];
  if (property->path.ends_with("/visible")) {
    member = values[0] != 0;
  } else if (property->components == 1) {
    member = values[0];
  } else {
    member = values;
  }
}

}  // namespace candela::gltf
