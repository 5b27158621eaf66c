// The side of the device under test.
#include "tests/scene/mitsuba/mitsuba_scenes.h"
#include "tests/trace/render/render_support.h"

namespace candela::mitsuba {

image::Film render(const scene::Scene& scene, const render::RenderSettings& settings) {
  return device::renderOnDevice(scene, settings).film;
}

}  // namespace candela::mitsuba
