// The work by which candidates are measured: scenes, and as much of each as a device does in a fraction of a second.
#pragma once
#include <string>
#include <vector>

#include "host/render/renderer.h"
#include "host/tune/search.h"

namespace candela::tune {

/// A scene and all settings but those that are tuned.
struct Work {
  scene::Scene scene;
  render::RenderSettings settings;
};

/// A box of 68 triangles, which fits into any cache but is too large to be tested in a row, and a mesh of 99,392 in a
/// room, both with a lamp.
std::vector<scene::Scene> builtInScenes();

/// What of the work is not left to timing.
struct WorkSize {
  std::optional<render::Extent> size;        ///< of the image; absent: at most the settings'
  std::optional<std::uint32_t> sampleCount;  ///< per pixel
};

/// Chooses size and samples, where they are absent, such that a render with the built-in choices takes about
/// kRunSeconds; the image grows before the samples do, since devices with many lanes need many pixels. Throws
/// InterruptedError if `control` stops it, and what Renderer::render throws.
void fitToDevice(render::Renderer& renderer, const WorkSize& asked, const render::RenderControl& control, Work& work);

inline constexpr double kRunSeconds = 0.2;

/// Renders the work with every candidate, in turn. Throws as fitToDevice() does.
std::vector<Row> measureWork(render::Renderer& renderer, std::span<const Work> works,
                             std::span<const Candidate> candidates, std::uint32_t repeats,
                             const render::RenderControl& control);

}  // namespace candela::tune
