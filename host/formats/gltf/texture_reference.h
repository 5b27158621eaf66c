// The parts of a texture reference that do not concern its image. All functions throw JsonError.
#pragma once
#include <cstdint>
#include <optional>

#include "host/formats/gltf/value.h"
#include "host/scene/texture.h"

namespace candela::gltf {
/// Reads wrapping and `magFilter`. There are no smaller copies of images (mipmaps), so that `minFilter` has no effect.
void readSampler(const Value& sampler, scene::TextureReference& reference);

/// Reads KHR_texture_transform: translation times rotation times scale.
void readTransform(const Value& transform, scene::TextureReference& reference);

/// Returns the set of texture coordinates, which KHR_texture_transform may override.
std::uint64_t texCoordSetOf(const Value& info, const std::optional<Value>& transform);

}  // namespace candela::gltf
