// Compares a whole picture of a device with the reference's, as a case.
#pragma once
#include <string>

#include "host/drivers/conformance/case.h"
#include "host/trace/render/request.h"

namespace candela::conformance {

/// Time limit for removing parts of a captured scene.
inline constexpr double kPictureShrinkSeconds = 20;

struct Picture {
  std::string scene = "cornell";  ///< see scenes.h
  render::RenderRequest request{};
  std::uint32_t subgroupSize = 0;  ///< that pipelines require; 0: as the driver chooses
  double alpha = 0;                ///< PictureTest::alpha

  render::RenderSettings settings() const;
};

/// Renders the picture on both sides and computes the verdict of host/judge/verify: decidable samples are equal, and
/// the paired test finds no difference of light. A failure names the pixel, and the path vertex and quantity at which
/// its path diverges from the reference's. Skipped if the device does not have the workgroup or the subgroup size.
/// Throws as Renderer::prepare() does.
Finding comparePicture(const Picture& picture, Workbench& workbench);

/// Creates the pipelines with which a session would render the picture, and renders nothing. Skipped as
/// comparePicture() is. Scenes are loaded by texels where the picture leaves it to the device, which cannot be
/// measured. Throws as device::kernelsOf() does.
Finding compilePicture(const Picture& picture, Workbench& workbench);

/// Captures sample 0 of the pixel of the picture that differs most, with the subgroup size of the picture. Throws as
/// capture::captureScene() does, and UsageError if the device lacks the workgroup or the subgroup size.
capture::Capture capturePicture(const Picture& picture, const vulkan::DeviceInfo& device,
                                const vulkan::PrepareShader& prepareShader = {});

}  // namespace candela::conformance
