// The container of a glTF file: JSON by itself, or JSON and a binary chunk in a GLB file.
#pragma once
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "host/formats/loading/loader.h"

namespace candela::gltf {

struct Container {
  nlohmann::json json;
  std::optional<std::string_view> binary;  ///< the chunk BIN of a GLB file
};

/// Returns whether the bytes begin like a GLB file or like a JSON object.
bool looksLikeGltf(std::string_view bytes);

/// Throws SceneError with line and column of an error in JSON (syntax, UTF-8, numbers beyond double precision, nesting
/// of more than 256 levels), and JsonError for a damaged GLB header or chunk.
Container readContainer(const scene::SceneFile& file);

}  // namespace candela::gltf
