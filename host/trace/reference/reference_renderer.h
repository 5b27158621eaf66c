// The independent tracer in double precision.
#pragma once
#include <memory>

#include "host/trace/render/renderer.h"

namespace candela::reference {

std::unique_ptr<render::Renderer> makeReferenceRenderer();

}  // namespace candela::reference
