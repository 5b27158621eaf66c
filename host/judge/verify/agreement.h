// Compares the device's image with the reference's, rendered with the same random numbers, and reports where they
// diverge.
#pragma once
#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "host/judge/verify/conclusion.h"
#include "host/judge/verify/decisions.h"
#include "host/judge/verify/light_test.h"
#include "host/judge/verify/undecided_decisions.h"
#include "host/trace/render/bad_sample_tally.h"
#include "host/trace/render/renderer.h"

namespace candela::verify {

/// Channels are equal if they differ by at most kRelativeTolerance of the larger value, or by kAbsoluteTolerance.
inline constexpr double kRelativeTolerance = 1e-4;
inline constexpr double kAbsoluteTolerance = 0x1p-26;

/// The first decision in which two paths differ. `rounding`: none differs within the recorded vertices.
enum class Cause { primitive, shadow, lobe, roulette, rounding };
inline constexpr std::array<const char*, 5> kCauseNames{"primitive", "shadow", "lobe", "roulette", "rounding"};

/// The pixels of one-sample images, compared one by one.
struct PixelAgreement {
  std::uint64_t pixels = 0;
  std::uint64_t equal = 0;
  std::uint64_t lit = 0;  ///< not black on at least one side
  std::uint64_t litEqual = 0;
  std::array<std::uint64_t, 5> causes{};  ///< numbers of pixels that differ, by Cause
  double worst = 0;                       ///< maximum difference of a channel
  std::uint32_t worstX = 0, worstY = 0;
  DecisionTest decisions;
  UndecidedDecisions undecided;  ///< of paths; empty for other integrators
  double referenceMean = 0;      ///< luminance

  double equalFraction() const { return pixels == 0 ? 1 : static_cast<double>(equal) / static_cast<double>(pixels); }
  double litEqualFraction() const { return lit == 0 ? 1 : static_cast<double>(litEqual) / static_cast<double>(lit); }
  /// Returns whether rounding explains all differences.
  bool agree() const { return decisions.agrees(); }
  /// Returns the causes with their counts, and the position of the maximum difference.
  std::string causesText() const;
  nlohmann::ordered_json json() const;
};

struct AgreementReport : RegionTests {
  std::string scene;
  render::RenderStatistics deviceStatistics;  ///< of the films; `truncated` counts the pixels' images, too
  PixelAgreement pixels;
  std::uint32_t samples = 0;              ///< per pixel, of the films
  double maxOverlooked = kMaxOverlooked;  ///< fraction of the image mean
  render::BadSampleTallies badSamples;    ///< of all renders
  image::Film deviceFilm, referenceFilm;  ///< films with `samples` samples per pixel
  bool interrupted = false;

  /// There is none of an interrupted comparison.
  Conclusion conclusion() const;
  /// Returns what leaves a comparison that found no difference undecided.
  Doubt doubt() const;
  /// Returns the conclusion in one or more sentences.
  std::string verdict() const;
  std::string toText() const;
  nlohmann::ordered_json toJson() const;
};

/// Returns why two records of one pixel diverge.
Cause causeOf(const render::PathRecord& device, const render::PathRecord& reference);
/// Compares results of one sample per pixel that contain path records.
PixelAgreement comparePixels(const render::RenderResult& device, const render::RenderResult& reference);

/// The properties of both renders that are known even if they were interrupted.
struct PathRenders {
  render::BadSampleTallies badSamples;
  render::RenderStatistics deviceStatistics;
};

/// Renders and compares images of one sample per pixel, and tests their decisions at `level`. Sets `deviceStatistics`
/// of `renders`, and adds to its bad samples. Returns nothing if a render was interrupted, since its records are
/// incomplete. The caller checks `truncated` of the statistics: truncated paths differ without a fault of the device's
/// arithmetic.
std::optional<PixelAgreement> comparePaths(const scene::Scene& scene, const render::RenderSettings& settings,
                                           render::Renderer& device, render::Renderer& reference, double level,
                                           const render::RenderControl& control, PathRenders& renders);

/// Renders `scene` on both sides: once with one sample for the pixels, and with `settings.image.sampleCount` for the
/// paired test of their light. Of `options`, only `alpha` and `bias` are used.
AgreementReport compareTracers(const scene::Scene& scene, const render::RenderSettings& settings,
                               render::Renderer& device, render::Renderer& reference, const LightTestOptions& options,
                               const render::RenderControl& control);

}  // namespace candela::verify
