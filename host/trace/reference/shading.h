// How a surface scatters light towards the origin of a ray: docs/light-transport.md sections 4, 5 and 5.8.
#pragma once
#include <optional>

#include "host/trace/reference/arithmetic.h"
#include "host/trace/reference/bsdf.h"
#include "host/trace/reference/normal_map.h"
#include "host/trace/reference/sampling.h"
#include "host/trace/reference/surface_material.h"
#include "host/trace/reference/vertex_numbers.h"

namespace candela::reference {

/// Turns the shading normal of a surface whose material, or whose coat, has a normal map. If it has a coat, one layer
/// is chosen, and `material` becomes this layer.
void mapLayer(const TextureReader& textures, const dvec3& rayDirection, VertexNumbers u, Surface& surface,
              SurfaceMaterial& material);

struct ShadingFrame {
  Frame frame;                            ///< around the shading normal
  std::optional<NormalMapFacets> facets;  ///< of a surface with a normal map
  dvec3 wo;                               ///< local; as the facet sees it, with a normal map

  /// The frame at a surface that a ray of this direction hits. The choice of a facet is a decision.
  ShadingFrame(const Surface& surface, const dvec3& rayDirection, Arithmetic& arithmetic);

  /// Returns the side on which `wi`, which is local, is.
  Side sideOf(const dvec3& wi) const;
};

/// The continuation of a path. A weight of 0 ends it.
struct Scattering {
  render::Lobe lobe = render::Lobe::none;
  dvec3 wi{0};                ///< in world space
  dvec3 weight{0};            ///< f |cos| / pdf
  std::optional<double> pdf;  ///< none for a delta lobe

  Side side() const { return lobe == render::Lobe::refract ? Side::transmission : Side::reflection; }
};

/// The lobes of a surface in its frame.
class Shading : public ShadingFrame {
 public:
  /// Sets the lobes of a material with surface parameters. `choice`: nothing if the surface does not disperse light.
  /// References must outlive the object.
  Shading(const Surface& at, SurfaceMaterial& material, const dvec3& rayDirection,
          const std::optional<ChannelChoice>& choice, Arithmetic& arithmetic);

  const Surface& surface() const { return surface_; }
  const Bsdf& bsdf() const { return bsdf_; }

  /// The vertex as the light tree sees it.
  LightReceiver receiver() const;
  dvec3 toLocal(const dvec3& world) const { return arithmetic_.direction(frame.toLocal(world)); }
  /// Returns f times the cosine for `wi`, which is in the local frame and on this side.
  BsdfValue valueOf(const dvec3& wi, Side side) const;
  /// Returns whether `wi`, in world space, is on this side of the geometric normal, too.
  bool isOn(Side side, const dvec3& wi) const;
  Ray rayTowards(const dvec3& wi, Side side) const;
  /// Chooses a lobe, and samples a direction.
  Scattering sample(VertexNumbers u) const;

 private:
  /// Returns the fraction of the light from `wi`, which is local, that the bumps of a normal map do not shadow.
  double bumpShadowing(const dvec3& wi) const;
  dvec3 toWorld(const dvec3& local) const { return arithmetic_.direction(frame.toWorld(local)); }
  Scattering sampleSurface(VertexNumbers u) const;
  Scattering sampleInterface(VertexNumbers u) const;
  Scattering sampleSmooth(render::Lobe lobe, VertexNumbers u) const;
  Scattering sampleDelta(render::Lobe lobe, VertexNumbers u) const;

  const Surface& surface_;
  const Bsdf& bsdf_;
  Arithmetic& arithmetic_;
};

}  // namespace candela::reference
