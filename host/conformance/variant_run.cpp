// Renders with both forms of a kernel.
#include "host/conformance/variant_run.h"

#include <fmt/format.h>

#include <cstring>

#include "host/conformance/scenes.h"
#include "host/conformance/workbench.h"
#include "host/device/gpu_renderer.h"

namespace candela::conformance {
namespace {

image::Film filmOf(const Picture& picture, const variants::Variant& variant, Workbench& workbench) {
  vulkan::DeviceOptions options;
  options.prepareShader = variants::preparation(variant);
  const auto renderer = device::makeGpuRenderer(workbench.open(options));
  return renderer->render(sceneNamed(picture.scene), picture.settings, {}).film;
}

Finding compareFilms(const image::Film& plain, const image::Film& film, const std::string& name) {
  std::size_t differing = 0, first = 0;
  for (std::size_t i = plain.pixels().size(); i-- > 0;) {
    if (std::memcmp(&plain.pixels()[i], &film.pixels()[i], sizeof(image::FilmPixel)) == 0) continue;
    ++differing;
    first = i;
  }
  if (differing == 0) return passed();
  const auto x = static_cast<std::uint32_t>(first % plain.width()),
             y = static_cast<std::uint32_t>(first / plain.width());
  const glm::dvec3 expected = plain.mean(x, y), found = film.mean(x, y);
  return failed(fmt::format("plain and {} differ in {} of {} pixels, the first is {},{}: {} {} {} and {} {} {}", name,
                            differing, plain.pixels().size(), x, y, expected.x, expected.y, expected.z, found.x,
                            found.y, found.z));
}

}  // namespace

Finding compareVariant(const Picture& picture, const variants::Variant& variant, Workbench& workbench) {
  return compareFilms(filmOf(picture, variants::plainVariant(), workbench), filmOf(picture, variant, workbench),
                      variant.name);
}

}  // namespace candela::conformance
