// The frame in which a surface scatters: docs/light-transport.md sections 4 and 5.8.
#pragma once
#include <optional>

#include "host/reference/arithmetic.h"
#include "host/reference/normal_map.h"
#include "host/reference/sampling.h"

namespace candela::reference {

struct ShadingFrame {
  Frame frame;                            ///< around the shading normal
  std::optional<NormalMapFacets> facets;  ///< of a surface with a normal map
  dvec3 wo;                               ///< local; as the facet sees it, with a normal map

  /// The frame at a surface that a ray of this direction hits. The choice of a facet is a decision.
  ShadingFrame(const Surface& surface, const dvec3& rayDirection, Arithmetic& arithmetic);

  /// Returns the side on which `wi`, which is local, is.
  Side sideOf(const dvec3& wi) const;
};

}  // namespace candela::reference
