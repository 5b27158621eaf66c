// Animated properties of materials, lights, cameras and nodes (KHR_animation_pointer).
#pragma once
#include <nlohmann/json.hpp>

#include "host/formats/gltf/animation_sampler.h"

namespace candela::gltf {

/// Sets a property of `document` to its animated value at `seconds`. `target` is that of a channel with the path
/// `pointer`; `sampler` is the channel's. Values beyond the range of a property, as splines have them between key
/// frames, are clamped to it. Throws JsonError if the pointer is none of the properties of docs/gltf.md, if the object
/// that would have the property does not exist, or if the sampler does not fit the property.
void setPointedProperty(const Value& target, const Value& sampler, double seconds, Accessors& accessors,
                        nlohmann::json& document);

}  // namespace candela::gltf
