// The scenes of this folder, rendered as the program renders them, and what their pictures must be.
#pragma once
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "host/trace/render/renderer.h"
#include "host/trace/render/request.h"

namespace candela::mitsuba {

/// Renders a picture. A program that is linked with reference_rendering.cpp uses the reference, and one with
/// device_rendering.cpp the device under test.
image::Film render(const scene::Scene& scene, const render::RenderSettings& settings);

/// How a scene is read: LoadOptions::camera, empty for the first one, and LoadOptions::definitions.
struct Reading {
  std::string camera{};
  std::vector<std::string> definitions{};
};

/// Reads a scene of this folder. Requires that there are no errors.
scene::Scene sceneNamed(const std::string& file, const Reading& reading = {});

/// Renders a scene with all settings that it requests.
image::Film pictureOf(const std::string& file, const Reading& reading = {});

/// Checks that the picture has one row of pixels with these means, to `tolerance` relative and five standard errors.
void checkRow(const std::string& file, const std::vector<glm::dvec3>& expected, const Reading& reading = {},
              double tolerance = 1e-3);

}  // namespace candela::mitsuba
