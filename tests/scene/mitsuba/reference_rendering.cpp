// The reference's side.
#include "host/trace/reference/reference_renderer.h"
#include "tests/scene/mitsuba/mitsuba_scenes.h"

namespace candela::mitsuba {

image::Film render(const scene::Scene& scene, const render::RenderSettings& settings) {
  return reference::makeReferenceRenderer()->render(scene, settings, {}).film;
}

}  // namespace candela::mitsuba
