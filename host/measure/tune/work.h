// The work on which candidates are measured: scenes, with sizes such that a render takes a fraction of a second.
#pragma once
#include <string>
#include <vector>

#include "host/measure/tune/search.h"
#include "host/trace/render/renderer.h"

namespace candela::tune {

/// A scene and all settings except those that are tuned.
struct Work {
  scene::Scene scene;
  render::RenderSettings settings;
};

/// Returns two scenes with an area light: a box of 68 triangles, which fits into any cache but is too large for a
/// linear list, and a mesh of 99,392 triangles in a room.
std::vector<scene::Scene> builtInScenes();

/// Work that is given rather than chosen by timing.
struct WorkSize {
  std::optional<render::Extent> size;        ///< size of the image; if empty, at most that of the settings
  std::optional<std::uint32_t> sampleCount;  ///< samples per pixel
};

/// Chooses size and samples, if they are empty, such that a render with the built-in choices takes about kRunSeconds.
/// The image is enlarged before the number of samples, since large devices need many pixels. Throws InterruptedError if
/// `control` stops it, and the exceptions of Renderer::render.
void fitToDevice(render::Renderer& renderer, const WorkSize& asked, const render::RenderControl& control, Work& work);

inline constexpr double kRunSeconds = 0.2;

/// Renders the work with every candidate, interleaved. Throws as fitToDevice() does.
std::vector<Row> measureWork(render::Renderer& renderer, std::span<const Work> works,
                             std::span<const Candidate> candidates, std::uint32_t repeats,
                             const render::RenderControl& control);

}  // namespace candela::tune
