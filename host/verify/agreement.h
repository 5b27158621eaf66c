// Compares the device's image with the reference's, rendered with the same random numbers, and reports where they
// diverge.
#pragma once
#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "host/render/bad_sample_tally.h"
#include "host/render/renderer.h"

namespace candela::verify {

/// Channels are equal if they differ by at most kRelativeTolerance of the larger value, or by kAbsoluteTolerance.
inline constexpr double kRelativeTolerance = 1e-4;
inline constexpr double kAbsoluteTolerance = 0x1p-26;
/// Required fractions of equal pixels at one sample: of all pixels, and of those that are lit on either side.
inline constexpr double kRequiredShare = 0.99;
inline constexpr double kRequiredLitShare = 0.97;
/// Maximum relative difference of the image means (luminance) at more samples.
inline constexpr double kMeanTolerance = 1e-3;

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

  double share() const { return pixels == 0 ? 1 : static_cast<double>(equal) / static_cast<double>(pixels); }
  double litShare() const { return lit == 0 ? 1 : static_cast<double>(litEqual) / static_cast<double>(lit); }
  bool agree() const { return share() >= kRequiredShare && litShare() >= kRequiredLitShare; }
  /// Returns the causes with their counts, and the position of the maximum difference.
  std::string causesText() const;
  nlohmann::ordered_json causesJson() const;
  nlohmann::ordered_json worstJson() const;
};

/// Means (luminance) of images with `samples` samples per pixel.
struct MeanAgreement {
  std::uint32_t samples = 0;
  double device = 0;
  double reference = 0;

  /// Returns |device - reference| / reference; 0 if both are 0.
  double relativeDifference() const;
  bool agree() const { return relativeDifference() <= kMeanTolerance; }
};

struct AgreementReport {
  std::string scene;
  render::RenderStatistics deviceStatistics;
  PixelAgreement pixels;
  MeanAgreement mean;
  render::BadSampleTallies badSamples;    ///< bad samples of all renders
  image::Film deviceFilm, referenceFilm;  ///< films with `samples` samples per pixel
  bool interrupted = false;

  bool agree() const { return !interrupted && pixels.agree() && mean.agree(); }
  std::string toText() const;
  nlohmann::json toJson() const;
};

/// Returns why two records of one pixel diverge.
Cause causeOf(const render::PathRecord& device, const render::PathRecord& reference);
/// Compares results of one sample per pixel that contain path records.
PixelAgreement comparePixels(const render::RenderResult& device, const render::RenderResult& reference);

/// Renders and compares images of one sample per pixel, and adds the bad samples of both to `badSamples`. Returns
/// nothing if a render was interrupted, since its records are incomplete.
std::optional<PixelAgreement> comparePaths(const scene::Scene& scene, const render::RenderSettings& settings,
                                           render::Renderer& device, render::Renderer& reference,
                                           const render::RenderControl& control, render::BadSampleTallies& badSamples);

/// Renders `scene` on both sides: once with one sample for the pixels, and with `settings.image.sampleCount` for the
/// means.
AgreementReport compareTracers(const scene::Scene& scene, const render::RenderSettings& settings,
                               render::Renderer& device, render::Renderer& reference,
                               const render::RenderControl& control);

}  // namespace candela::verify
