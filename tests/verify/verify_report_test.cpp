// The text of the verdict in each format.
#include <atomic>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "host/verify/verify.h"
#include "tests/verify/noise_renderer.h"

namespace candela::verify {
namespace {

using Catch::Contains;

// Paths are not compared here, because the renderers make only noise.
VerifyReport reportOf(double deviceFactor, std::optional<scene::ExactMean> exact = std::nullopt,
                      double referenceFactor = 1) {
  const auto everywhere = [](double factor) { return [=](std::uint32_t, std::uint32_t) { return factor; }; };
  NoiseRenderer a({.deviation = 0.5, .factor = everywhere(deviceFactor)});
  NoiseRenderer b({.factor = everywhere(referenceFactor)});
  scene::Scene scene;
  scene.name = "a<b>.p3f";
  render::RenderSettings settings;
  settings.image.size = {16, 16};
  VerifyReport report;
  report.scene = scene.name;
  report.light = testLight(scene, settings, a, b, report.options, {});
  report.paths.pixels = report.paths.equal = 256;
  if (exact) report.exact = ExactTest{.expected = 1, .device = 2, .reference = 2, .devicePValue = 0, .level = 5e-5};
  return report;
}

TEST_CASE("an agreement states the difference that would have been detected") {
  const VerifyReport report = reportOf(1);
  CHECK(report.agree());
  CHECK_THAT(report.verdict(), Contains("compute the same light") && Contains("99 % probability"));
  CHECK(toJson(report)["agrees"] == true);
  CHECK(toJson(report)["schema"] == "candela-verify/2");
  CHECK_THAT(toText(report), Contains("the scene does not state an exact result"));
}

TEST_CASE("a verdict is weak if it could not detect 1 %, and says so") {
  VerifyReport report = reportOf(1);
  CHECK_FALSE(report.isWeak());
  CHECK(toJson(report)["weak"] == false);
  CHECK_THAT(report.verdict(), !Contains("weak"));
  report.light.regions.front().detectableBias = 0.0101;
  CHECK(report.isWeak());
  CHECK(report.agree());
  CHECK(toJson(report)["weak"] == true);
  CHECK_THAT(toText(report), Contains("This verdict is weak: errors of 1 % may have gone unnoticed."));
}

TEST_CASE("two black pictures are said to be black, and not to have the same light") {
  const VerifyReport report = reportOf(0, std::nullopt, 0);
  CHECK(report.agree());
  CHECK(report.isWeak());
  CHECK_THAT(toText(report), Contains("Device and reference are both black: no light was compared.") &&
                                 Contains("image mean (luminance): 0, reference 0 (") && !Contains("would have been"));
}

TEST_CASE("light on a device whose reference is black is stated in absolute terms") {
  const VerifyReport report = reportOf(1, std::nullopt, 0);
  CHECK_FALSE(report.agree());
  CHECK_FALSE(report.isWeak());
  CHECK_THAT(report.verdict(), Contains("on the device and black on the reference") && !Contains(" %"));
}

TEST_CASE("a difference is reported with its position, size and sign") {
  const VerifyReport report = reportOf(0.98);
  CHECK_FALSE(report.agree());
  CHECK_THAT(report.verdict(),
             Contains("do NOT compute the same light") && Contains("image mean") && Contains("darker"));
  CHECK(toJson(report)["sameLight"]["agrees"] == false);
}

TEST_CASE("two sides that agree on a wrong result fail") {
  const VerifyReport report = reportOf(1, scene::ExactMean{});
  CHECK_FALSE(report.agree());
  CHECK_THAT(report.verdict(), Contains("NOT with the exact result that the scene states"));
  CHECK(toJson(report)["rightLight"]["agrees"] == false);
}

TEST_CASE("JUnit has a case for each question, including failures, and is well-formed for any scene name") {
  CHECK_THAT(toJunit(reportOf(1), false), Contains("tests=\"2\" failures=\"0\"") && Contains("a&lt;b&gt;.p3f"));
  const std::string failed = toJunit(reportOf(0.98, scene::ExactMean{}), false);
  CHECK_THAT(failed, Contains("\">Device and reference do NOT") && Contains("</failure>"));
  CHECK_THAT(failed, Contains("tests=\"3\" failures=\"2\"") &&
                         Contains("<failure type=\"Fail\" message=\"Device and reference do NOT"));
}

TEST_CASE("a run that is interrupted in its first question reports its device and its time") {
  NoiseRenderer device, reference;
  device.name = "a device";
  const std::atomic<bool> stop = true;
  render::RenderControl control;
  control.stop = &stop;
  render::RenderSettings settings;
  settings.image.size = {16, 16};
  const VerifyReport report = verifyScene({}, settings, device, reference, {}, control);
  CHECK(report.interrupted);
  CHECK(toJson(report)["agrees"].is_null());
  CHECK(report.seconds > 0);
  CHECK(toJson(report)["device"] == "a device");
  CHECK(toJson(report)["driver"] == "a driver");
  CHECK_THAT(toText(report), Contains("a device compared with the reference"));
}

TEST_CASE("JUnit reports bad samples as a failure only if they are forbidden") {
  VerifyReport report = reportOf(1);
  CHECK_THAT(toJunit(report, true), Contains("tests=\"3\" failures=\"0\""));
  image::Film film(16, 16);
  film.addSample(3, 4, glm::dvec3(-1), 0);
  render::ImageSettings image;
  image.size = {16, 16};
  report.badSamples.device.add(film, image);
  CHECK_THAT(toJunit(report, true),
             Contains("tests=\"3\" failures=\"1\"") && Contains("<failure type=\"Fail\" message=\"1 bad samples\""));
  CHECK_THAT(toJunit(report, false), Contains("tests=\"2\" failures=\"0\""));
  CHECK(report.agree());
}

}  // namespace
}  // namespace candela::verify
