// Warns of the shapes of polygons.
#include "host/formats/loading/polygon.h"

namespace candela::scene {

Triangulation triangulateWithWarnings(std::span<const glm::vec3> polygon, Position position, DiagnosticLog& log) {
  constexpr double kFlatness = 1e-2;  // as a fraction of the extent: measured data deviate by half of it
  Triangulation split = triangulate(polygon);
  if (split.planeDeviation > kFlatness) {
    log.warn("not planar", position, "the polygon is not flat; its triangles follow its vertices");
  }
  if (!split.simple) log.warn("crosses itself", position, "the polygon crosses itself; its triangles may overlap");
  return split;
}

}  // namespace candela::scene
