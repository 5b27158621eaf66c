// Names for what paths meet and decide.
#pragma once
#include <string>

#include "host/render/path_trace.h"
#include "host/scene/scene.h"

namespace candela::explain {

/// Index and kind, e.g. "7 sphere"; the index alone where the scene has no such entry.
std::string primitiveWords(std::uint32_t primitive, const scene::Scene& scene);
/// The same of a material, e.g. "2 mixture": docs/light-transport.md section 5.
std::string materialWords(std::uint32_t material, const scene::Scene& scene);
/// Of LightTrace::primitive.
std::string lightWords(std::uint32_t primitive, const scene::Scene& scene);
std::string lobeWords(render::Lobe lobe);
std::string shadowWords(render::ShadowOutcome outcome);

}  // namespace candela::explain
