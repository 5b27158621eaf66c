// Captures two variants of a kernel whose results differ.
#pragma once
#include "host/drivers/conformance/picture_run.h"
#include "host/drivers/variants/variant.h"

namespace candela::conformance {

/// Captures the first sample of the picture in whose bits the plain form and the variant differ, with the bits of the
/// plain form as expected values; sample 0 of pixel 0,0 if none does. Throws as capture::captureScene() does.
capture::Capture captureForms(const Picture& picture, const variants::Variant& variant,
                              const vulkan::DeviceInfo& device);

/// Captures the variant with the reference's values as the expected ones. Throws as capturePicture() does.
capture::Capture captureVerdict(const Picture& picture, const variants::Variant& variant,
                                const vulkan::DeviceInfo& device);

/// Captures a case with the variant of its module. Throws as captureCase() does.
capture::Capture captureModule(const Case& question, const variants::Variant& variant,
                               const vulkan::DeviceInfo& device);

}  // namespace candela::conformance
