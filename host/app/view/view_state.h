// The state of a viewer that input changes: the choice of the picture and its display.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>

#include "host/app/view/schedule.h"
#include "host/image/image.h"
#include "host/trace/render/extent.h"

namespace candela::view {

/// The picture that a viewer shows. `split`: the device to the left of the divider, the reference to its right.
/// `difference`: device minus reference, divided by their mean luminance.
enum class Mode : std::uint32_t { device, reference, split, difference };
constexpr bool comparesSides(Mode mode) { return mode >= Mode::split; }
constexpr bool wants(Mode mode, Side side) {
  return comparesSides(mode) || (mode == Mode::reference) == (side == Side::reference);
}

/// The position of a picture in a window: pixel p of the picture is at `origin` + `zoom` p, in pixels of the window.
struct Placement {
  glm::dvec2 origin{0};
  double zoom = 1;

  glm::dvec2 toPicture(const glm::dvec2& window) const { return (window - origin) / zoom; }
  /// Changes the zoom so that the picture stays at the same place below `pivot`, a position in the window.
  void zoomAt(const glm::dvec2& pivot, double newZoom);
};

/// Returns the placement in which the whole picture is as large as possible, in the middle of a window without its left
/// `margin` pixels; a picture that fits is not magnified by a fraction.
Placement placed(const render::Extent& picture, const render::Extent& window, std::uint32_t margin = 0);

struct ViewState {
  static constexpr float kMaxExposure = 32;
  static constexpr double kMinZoom = 1.0 / 64, kMaxZoom = 64;
  static constexpr int kMaxGainStops = 30;

  Mode mode = Mode::device;
  double divider = 0.5;             ///< of the picture's width, in [0, 1]
  image::DisplayTransform display;  ///< of files, too
  int differenceStops = 0;          ///< the difference is multiplied by 2 to the power of this, in [0, kMaxGainStops]
  bool arePanelsShown = true;
  bool isPaused = false;
  Placement placement{};
  glm::dvec2 pointer{-1, -1};             ///< in the window
  std::optional<glm::uvec2> inspected{};  ///< pixel whose path is shown
  std::uint32_t inspectedSample = 0;
};

/// Returns the pixel of a picture at a position of the window, if there is one.
std::optional<glm::uvec2> pixelAt(const ViewState& state, const render::Extent& picture, const glm::dvec2& window);

/// Selects the next display transform for light, in the order of the option --tonemap; false colours stay.
void cycleToneMap(ViewState& state);

}  // namespace candela::view
