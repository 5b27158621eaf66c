// The independent tracer in double precision.
#pragma once
#include <memory>

#include "host/render/replay.h"

namespace candela::reference {

std::unique_ptr<render::ReplayingRenderer> makeReferenceRenderer();

}  // namespace candela::reference
