// Common parts of the tests of rendering on a device.
#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "host/formats/loading/load.h"
#include "host/trace/device/gpu_renderer.h"
#include "host/trace/reference/reference_renderer.h"

namespace candela::device {

/// Pixels that must be equal at one sample in the scenes of the tests, whose rounding is not amplified: of all pixels,
/// and of those that are lit on either side. And the relative difference of image means of many samples.
inline constexpr double kRequiredEqualFraction = 0.99;
inline constexpr double kRequiredLitEqualFraction = 0.97;
inline constexpr double kMeanTolerance = 1e-3;

/// The files of scenes/, sorted.
std::vector<std::filesystem::path> sceneFiles();
scene::Scene loadTestScene(const std::string& fileName);
/// scenes/primitives.p3f (every primitive, mirrors, glass, patches, mixtures) under eleven point lights: more than
/// Whitted's tracer tests in one segment.
scene::Scene primitivesUnderLights();

/// A sample of Haines' databases, of tests/formats/nff/spd/.
scene::Scene loadSpdScene(const std::string& fileName);
/// A scene from text, without warnings printed.
scene::Scene sceneFromText(const std::string& text);

/// Settings for square pictures with this side in pixels and this number of samples per pixel; the rest are defaults.
render::RenderSettings squareSettings(std::uint32_t side, std::uint32_t samples);

/// Renders on the device under test, and requires that no loop was truncated.
render::RenderResult renderOnDevice(const scene::Scene& scene, const render::RenderSettings& settings);
render::RenderResult renderOnReference(const scene::Scene& scene, const render::RenderSettings& settings);
/// The renderer on that device, kept so that equal kernels are compiled once.
render::Renderer& testRenderer();
/// The device that CANDELA_TEST_DEVICE selects; empty: the best device.
std::string testDevice();

/// Checks that both sides did the same work, and that no loop was truncated.
void requireEqualCounts(const render::RenderStatistics& a, const render::RenderStatistics& b);

double meanLuminance(const image::Film& film);
/// Mean of one pixel's luminance.
double pixelLuminance(const image::Film& film, std::uint32_t x, std::uint32_t y);

}  // namespace candela::device
