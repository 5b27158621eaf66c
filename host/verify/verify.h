// The verdict of `candela verify`: whether device and reference compute the same light, and whether it is correct.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "host/render/bad_sample_tally.h"
#include "host/verify/agreement.h"
#include "host/verify/exact_test.h"
#include "host/verify/light_test.h"

namespace candela::verify {

/// A verdict that could not detect a bias of this fraction of the image mean is weak.
inline constexpr double kWeakBias = 0.01;

struct VerifyReport {
  std::string scene;
  render::RenderStatistics deviceStatistics;  ///< statistics of the render for question 1
  LightTestOptions options;
  PixelAgreement paths;            ///< 1: same numbers, same paths?
  LightTestResult light;           ///< 2: same light?
  std::optional<ExactTest> exact;  ///< 3: right light? Only for scenes that state their exact result
  double seconds = 0;
  render::BadSampleTallies badSamples;  ///< of all renders
  bool interrupted = false;

  bool agree() const { return !interrupted && paths.agree() && !light.differs() && (!exact || exact->isMet()); }
  /// Returns whether the agreement says little: a bias of kWeakBias may have gone unnoticed, or the picture is black.
  bool isWeak() const;
  /// Returns one sentence with the result and its certainty, and another if it is weak.
  std::string verdict() const;
};

/// Answers the three questions in their order; all are answered, whatever the first results are.
/// `settings.image.sampleCount` is not used. Throws as testLight does.
VerifyReport verifyScene(const scene::Scene& scene, const render::RenderSettings& settings, render::Renderer& device,
                         render::Renderer& reference, const LightTestOptions& options,
                         const render::RenderControl& control);

std::string toText(const VerifyReport& report);
nlohmann::ordered_json toJson(const VerifyReport& report);
/// Returns a JUnit test suite with a case for each question. `strict` adds a case for the absence of bad samples.
std::string toJunit(const VerifyReport& report, bool strict);

}  // namespace candela::verify
