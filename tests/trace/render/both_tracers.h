// Runs the body of a test on each tracer, as a separate section.
#pragma once
#include <catch2/catch.hpp>
#include <functional>

#include "tests/trace/render/render_support.h"

namespace candela::device {

using RenderFunction = std::function<render::RenderResult(const scene::Scene&, const render::RenderSettings&)>;

inline void onBothTracers(const std::function<void(const RenderFunction&)>& body) {
  SECTION("device") { body(renderOnDevice); }
  SECTION("reference") { body(renderOnReference); }
}

}  // namespace candela::device
