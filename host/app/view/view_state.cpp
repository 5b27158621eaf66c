// Geometry and choices of the view.
#include "host/app/view/view_state.h"

#include <algorithm>
#include <cmath>

#include "host/image/false_colour.h"

namespace candela::view {

void Placement::zoomAt(const glm::dvec2& pivot, double newZoom) {
  const glm::dvec2 kept = toPicture(pivot);
  zoom = std::clamp(newZoom, ViewState::kMinZoom, ViewState::kMaxZoom);
  origin = pivot - zoom * kept;
}

Placement placed(const render::Extent& picture, const render::Extent& window, std::uint32_t margin) {
  const render::Extent room{window.width - std::min(margin, window.width - 1), window.height};
  const double fitting = std::min(1.0 * room.width / picture.width, 1.0 * room.height / picture.height);
  const double zoom = std::clamp(fitting >= 1 ? std::floor(fitting) : fitting, ViewState::kMinZoom,
                                 ViewState::kMaxZoom);
  const glm::dvec2 free = glm::dvec2(room.width, room.height) - zoom * glm::dvec2(picture.width, picture.height);
  return {glm::floor(free / 2.0) + glm::dvec2(window.width - room.width, 0), zoom};
}

std::optional<glm::uvec2> pixelAt(const ViewState& state, const render::Extent& picture, const glm::dvec2& window) {
  const glm::dvec2 at = state.placement.toPicture(window);
  if (!(at.x >= 0 && at.y >= 0 && at.x < picture.width && at.y < picture.height)) return std::nullopt;
  return glm::uvec2(at);
}

void cycleToneMap(ViewState& state) {
  if (isFalseColour(state.display.toneMap)) return;
  const auto next = static_cast<int>(state.display.toneMap) + 1;
  state.display.toneMap = next > static_cast<int>(image::ToneMap::neutral) ? image::ToneMap::none
                                                                           : static_cast<image::ToneMap>(next);
}

}  // namespace candela::view
