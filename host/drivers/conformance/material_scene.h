// Small scenes of glTF, each of which shows one material.
#pragma once
#include <string>
#include <string_view>

#include "host/scene/generate/gltf_material.h"

namespace candela::conformance {

struct MaterialScene {
  std::string_view name;
  generate::MaterialFactors factors{};
  bool hasTexture = false;            ///< the floor has an image as its base colour
  std::string_view environment = {};  ///< as --env; empty: the default light of glTF
};

/// Returns the scene, or null if there is none of this name.
const MaterialScene* materialScene(std::string_view name);

/// Returns the file: a ball of the material on a floor.
std::string textOf(const MaterialScene& scene);

}  // namespace candela::conformance
