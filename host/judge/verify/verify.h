// The verdict of `candela verify`: whether device and reference compute the same light, and whether it is correct.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "host/judge/verify/agreement.h"
#include "host/judge/verify/exact_test.h"
#include "host/judge/verify/light_test.h"
#include "host/trace/render/bad_sample_tally.h"

namespace candela::verify {

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

  /// There is none of an interrupted verification.
  Conclusion conclusion() const;
  /// Returns what leaves question 2 undecided, whatever the other questions found.
  Doubt doubt() const;
  /// Returns whether noise hides too much from question 3, which found no difference.
  bool isExactOpen() const;
  /// Returns one or more sentences with the result and its certainty, or with what leaves it undecided.
  std::string verdict() const;
};

/// Answers the three questions in their order; all are answered, whatever the first results are.
/// `settings.image.sampleCount` is not used. Throws as testLight does.
VerifyReport verifyScene(const scene::Scene& scene, const render::RenderSettings& settings, render::Renderer& device,
                         render::Renderer& reference, const LightTestOptions& options,
                         const render::RenderControl& control);

std::string toText(const VerifyReport& report);
nlohmann::ordered_json toJson(const VerifyReport& report);

/// The choice of what a JUnit test suite counts as a failure.
struct JunitOptions {
  bool strict = false;           ///< adds a case for the absence of bad samples
  bool allowsUndecided = false;  ///< a question that is not decided is skipped, and does not fail
};
/// Returns a JUnit test suite with a case for each question.
std::string toJunit(const VerifyReport& report, const JunitOptions& options);

}  // namespace candela::verify
