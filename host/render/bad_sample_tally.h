// Keeps count of the samples that films could not hold, over one render or many, and of where they fell.
#pragma once
#include <cstdint>
#include <vector>

#include "host/render/renderer.h"

namespace candela::render {

/// A pixel of one render in which samples were bad: see FilmPixel::badCount.
struct BadPixel {
  std::uint32_t x = 0, y = 0;
  std::uint32_t badCount = 0;     ///< in that render
  std::uint32_t firstSample = 0;  ///< index of the lowest
  std::uint32_t seed = 0;         ///< of that render, as its number of samples
  std::uint32_t sampleCount = 0;

  bool operator==(const BadPixel&) const = default;
};

/// All renders that are added must be of one size.
class BadSampleTally {
 public:
  static constexpr std::size_t kPixelsKept = 5;

  /// What `settings` rendered.
  void add(const image::Film& film, const RenderSettings& settings);

  std::uint64_t samples() const { return samples_; }
  /// Pixels with bad samples, each counted once however many renders it was bad in.
  std::uint64_t pixels() const { return pixels_; }
  /// The first of them, at most kPixelsKept: by render, then row by row from the top.
  const std::vector<BadPixel>& firstPixels() const { return firstPixels_; }

 private:
  std::uint64_t samples_ = 0;
  std::uint64_t pixels_ = 0;
  std::vector<bool> isBad_;  ///< by pixel; empty while there is none
  std::vector<BadPixel> firstPixels_;
};

/// Renders as another renderer does, and tells a tally of it. What is referred to must outlive the object.
class TalliedRenderer final : public Renderer {
 public:
  TalliedRenderer(Renderer& renderer, BadSampleTally& tally) : renderer_(renderer), tally_(tally) {}

  RenderResult render(const scene::Scene& scene, const RenderSettings& settings,
                      const RenderControl& control) override {
    RenderResult result = renderer_.render(scene, settings, control);
    tally_.add(result.film, settings);
    return result;
  }

 private:
  Renderer& renderer_;
  BadSampleTally& tally_;
};

}  // namespace candela::render
