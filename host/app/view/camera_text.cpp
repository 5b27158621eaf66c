// Formats views as docs/scene-format.md describes them.
#include "host/app/view/camera_text.h"

#include <fmt/format.h>

namespace candela::view {
namespace {

std::string vectorText(const char* name, const glm::vec3& v) {
  return fmt::format("{} {} {} {}\n", name, v.x, v.y, v.z);
}

}  // namespace

std::string cameraText(const scene::Camera& camera) {
  std::string text;
  if (camera.orthographicHeight) {
    text += fmt::format("# orthographic, height {}: NFF has only perspective cameras\n", *camera.orthographicHeight);
  }
  if (camera.shift != glm::vec2(0)) {
    text += fmt::format("# shifted by {} {}: the axis of views of NFF is in their centre\n", camera.shift.x,
                        camera.shift.y);
  }
  if (camera.isMirrored) text += "# mirrored: views of NFF are not\n";
  text += "v\n" + vectorText("from", camera.from) + vectorText("at", camera.at) + vectorText("up", camera.up);
  text += fmt::format("angle {}\nhither {}\nresolution {} {}\n", camera.angle, camera.hither, camera.width,
                      camera.height);
  if (camera.aperture > 0) text += fmt::format("aperture {}\nfocal {}\n", camera.aperture, camera.focal);
  return text;
}

}  // namespace candela::view
