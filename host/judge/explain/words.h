// Names for primitives, materials, lights, lobes and shadow rays.
#pragma once
#include <string>

#include "host/scene/scene.h"
#include "host/trace/render/path_trace.h"

namespace candela::explain {

/// Returns index and kind, e.g. "7 sphere"; only the index if the scene has no such entry.
std::string primitiveWords(std::uint32_t primitive, const scene::Scene& scene);
/// Returns index and kind of a material, e.g. "2 mixture": docs/light-transport.md section 5.
std::string materialWords(std::uint32_t material, const scene::Scene& scene);
/// Returns the name of a LightTrace::primitive.
std::string lightWords(std::uint32_t primitive, const scene::Scene& scene);
std::string lobeWords(render::Lobe lobe);
std::string shadowWords(render::ShadowOutcome outcome);

}  // namespace candela::explain
