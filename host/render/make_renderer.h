// Makes the two tracers.
#pragma once
#include <memory>
#include <string>

#include "host/render/renderer.h"

namespace candela {

/// The compute-shader tracer on the device that `selector` names (see selectDevice).
/// Throws NoDeviceError.
std::unique_ptr<Renderer> makeGpuRenderer(const std::string& selector);
/// The independent double-precision tracer.
std::unique_ptr<Renderer> makeReferenceRenderer();

}  // namespace candela
