// What the tests of rendering on a device share.
#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "host/render/make_renderer.h"
#include "host/scene/load.h"

namespace candela {

/// The files of scenes/, sorted.
std::vector<std::filesystem::path> sceneFiles();
Scene loadTestScene(const std::string& fileName);
/// scenes/primitives.p3f (every primitive, mirrors, glass, patches, mixtures) under eleven point lights: more than
/// Whitted's tracer asks in one segment.
Scene primitivesUnderLights();

/// A sample of Haines' databases, of tests/scene/spd/.
Scene loadSpdScene(const std::string& fileName);
/// A scene from text, without warnings printed.
Scene sceneFromText(const std::string& text);

/// Square pictures of so many pixels a side and samples per pixel, other settings at their defaults.
RenderSettings squareSettings(std::uint32_t side, std::uint32_t samples);

/// Renders on the device under test, and requires that no loop was truncated.
RenderResult renderOnDevice(const Scene& scene, const RenderSettings& settings);
RenderResult renderOnReference(const Scene& scene, const RenderSettings& settings);
/// The renderer on that device, kept so that equal kernels are compiled once.
Renderer& testRenderer();
/// What CANDELA_TEST_DEVICE selects; empty: the best device.
std::string testDevice();

double meanLuminance(const Film& film);
/// Mean of one pixel's luminance.
double pixelLuminance(const Film& film, std::uint32_t x, std::uint32_t y);

}  // namespace candela
