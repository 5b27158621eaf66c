// Sessions that tests run on all renderers.
#pragma once
#include <catch2/catch.hpp>
#include <functional>

#include "tests/trace/render/render_support.h"

namespace candela::device {

inline constexpr std::uint32_t kSamples = 8;

using SessionCheck = std::function<void(render::Renderer&)>;

/// The device with one band and with several, and the reference.
inline void onAllRenderers(const SessionCheck& check) {
  SECTION("device") { check(testRenderer()); }
  SECTION("device, in bands") {
    const auto renderer = makeGpuRenderer(testDevice(), {.loopLimit = std::nullopt, .maxBandBytes = 64 << 10});
    check(*renderer);
  }
  SECTION("reference") { check(*reference::makeReferenceRenderer()); }
}

inline render::RenderSettings sessionSettings() {
  render::RenderSettings settings = squareSettings(40, kSamples);
  settings.image.maxDepth = 6;
  return settings;
}

}  // namespace candela::device
