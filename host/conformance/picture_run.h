// Compares a whole picture of a device with the reference's, as a case.
#pragma once
#include <string>

#include "host/conformance/case.h"
#include "host/render/settings.h"

namespace candela::conformance {

/// Probability that a picture of a correct device fails.
inline constexpr double kPictureAlpha = 1e-5;

/// Renders the scene named `sceneName` (see scenes.h) on both sides and asks for the verdict of host/verify: decidable
/// samples are equal, and the paired test finds no difference of light. A failure names the pixel, and the path vertex
/// and quantity where its path leaves the reference's. Throws as Renderer::prepare() does.
Finding comparePicture(const std::string& sceneName, const render::RenderSettings& settings, Workbench& workbench);

}  // namespace candela::conformance
