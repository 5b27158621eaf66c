// Checked JSON values under the names that this folder uses, and the extensions of a glTF object.
#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <string_view>

#include "host/base/json_value.h"

namespace candela::gltf {

using Value = JsonValue;

/// Returns the member `name` of the member `extensions` of an object, if there is one.
inline std::optional<Value> extensionOf(const Value& object, std::string_view name) {
  const std::optional<Value> extensions = object.find("extensions");
  return extensions ? extensions->find(name) : std::nullopt;
}

}  // namespace candela::gltf
