// The text of the verdict in each format.
#include <atomic>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "host/judge/verify/verify.h"
#include "tests/judge/verify/noise_renderer.h"
#include "tests/trace/reference/default_settings.h"

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
  render::RenderSettings settings = render::defaultSettings();
  settings.image.size = {16, 16};
  VerifyReport report;
  report.scene = scene.name;
  report.light = testLight(scene, settings, a, b, report.options, {});
  report.paths.pixels = report.paths.equal = 256;
  if (exact)
    report.exact = ExactTest{
        .expected = 1, .device = 2, .reference = 2, .devicePValue = 0, .referencePValue = 0, .level = 5e-5};
  return report;
}

TEST_CASE("an agreement states the difference that would have been detected") {
  const VerifyReport report = reportOf(1);
  CHECK(report.conclusion() == Conclusion::same);
  CHECK_THAT(report.verdict(), Contains("compute the same light") && Contains("99 % probability"));
  CHECK(toJson(report)["agrees"] == true);
  CHECK(toJson(report)["schema"] == "candela-verify/3");
  CHECK_THAT(toText(report), Contains("the scene does not state an exact result"));
}

TEST_CASE("noise that may hide more than 1 % leaves a verdict undecided, unless a larger bias is stated") {
  VerifyReport report = reportOf(1);
  CHECK(report.doubt() == Doubt::none);
  CHECK(toJson(report)["undecided"].is_null());
  report.light.regions.front().detectableBias = 0.0101;
  CHECK(report.doubt() == Doubt::noise);
  CHECK(report.conclusion() == Conclusion::undecided);
  CHECK(toJson(report)["agrees"].is_null());
  CHECK(toJson(report)["sameLight"]["agrees"].is_null());
  CHECK(toJson(report)["undecided"]["reason"] == "noise");
  CHECK_THAT(toText(report), Contains("2 Same light?                not decided") &&
                                 Contains("noise may hide a difference of 1 % of the image mean") &&
                                 !Contains("compute the same light"));
  report.options.bias = 0.02;
  CHECK(report.conclusion() == Conclusion::same);
}

TEST_CASE("two black pictures are said to be black, and not to have the same light") {
  VerifyReport report = reportOf(0, std::nullopt, 0);
  CHECK(report.conclusion() == Conclusion::undecided);
  CHECK(toJson(report)["undecided"]["reason"] == "darkness");
  CHECK_THAT(toText(report), Contains("The device and the reference are both black: no light was compared.") &&
                                 Contains("image mean (luminance): 0, reference 0 (") && !Contains("would have been"));
  report.exact = ExactTest{.expected = 0, .level = 5e-5};
  CHECK(report.conclusion() == Conclusion::same);
  CHECK_THAT(report.verdict(), Contains("both black, as the scene states"));
}

TEST_CASE("light on a device whose reference is black is stated in absolute terms") {
  const VerifyReport report = reportOf(1, std::nullopt, 0);
  CHECK(report.conclusion() == Conclusion::different);
  CHECK_THAT(report.verdict(), Contains("on the device and black on the reference") && !Contains(" %"));
}

TEST_CASE("a difference is reported with its position, size and sign") {
  const VerifyReport report = reportOf(0.98);
  CHECK(report.conclusion() == Conclusion::different);
  CHECK_THAT(report.verdict(),
             Contains("do NOT compute the same light") && Contains("image mean") && Contains("darker"));
  CHECK(toJson(report)["sameLight"]["agrees"] == false);
}

TEST_CASE("two sides that agree on a wrong result fail") {
  const VerifyReport report = reportOf(1, scene::ExactMean{});
  CHECK(report.conclusion() == Conclusion::different);
  CHECK_THAT(report.verdict(), Contains("agree with each other, but NOT with the exact result that the scene states: "
                                        "the device has 2 and the reference has 2 instead of 1"));
  CHECK(toJson(report)["rightLight"]["agrees"] == false);
}

TEST_CASE("sides that miss the exact mean are not said to agree if their light is undecided, or if one has it") {
  VerifyReport report = reportOf(1, scene::ExactMean{});
  report.exact->device = 0.54;
  report.exact->reference = 0.74;
  report.light.regions.front().excused = report.light.image().referenceMean;
  CHECK_THAT(report.verdict(), Contains("NOT the exact result") &&
                                   Contains("the device has 0.54 and the reference has 0.74") &&
                                   Contains("Whether both have the same light is not decided") && !Contains("agree"));
  report = reportOf(1, scene::ExactMean{});
  report.exact->devicePValue = 1;
  CHECK_THAT(report.verdict(),
             Contains(": the reference has 2 instead of 1") && !Contains("the device") && !Contains("agree"));
}

TEST_CASE("noise that hides too much from the exact mean leaves the verdict undecided") {
  VerifyReport report = reportOf(1, scene::ExactMean{});
  report.exact = ExactTest{.expected = 1, .device = 1, .reference = 1, .level = 5e-5, .detectableBias = 0.009};
  CHECK(report.conclusion() == Conclusion::same);
  report.exact->detectableBias = 0.02;
  CHECK(report.conclusion() == Conclusion::undecided);
  CHECK_THAT(toText(report), Contains("3 Right light?               not decided") &&
                                 Contains("noise may hide a difference of 2 % from the exact result"));
  CHECK(toJson(report)["rightLight"]["agrees"].is_null());
  report.options.bias = 0.03;
  CHECK(report.conclusion() == Conclusion::same);
}

TEST_CASE("JUnit has a case for each question, including failures, and is well-formed for any scene name") {
  CHECK_THAT(toJunit(reportOf(1), {}), Contains("tests=\"2\" failures=\"0\"") && Contains("a&lt;b&gt;.p3f"));
  const std::string failed = toJunit(reportOf(0.98, scene::ExactMean{}), {});
  CHECK_THAT(failed, Contains("\">Device and reference do NOT") && Contains("</failure>"));
  CHECK_THAT(failed, Contains("tests=\"3\" failures=\"2\"") &&
                         Contains("<failure type=\"Fail\" message=\"Device and reference do NOT"));
}

TEST_CASE("JUnit fails a question that is not decided, and skips it if that is allowed") {
  VerifyReport report = reportOf(1);
  report.light.regions.front().excused = 0.02 * report.light.image().referenceMean;
  CHECK_THAT(toJunit(report, {}), Contains("tests=\"2\" failures=\"1\" skipped=\"0\"") &&
                                      Contains("<failure type=\"NotDecided\" message=\"2 Same light?") &&
                                      Contains("rounding in single precision excuses"));
  CHECK_THAT(toJunit(report, {.allowsUndecided = true}),
             Contains("tests=\"2\" failures=\"0\" skipped=\"1\"") && Contains("<skipped message=\"2 Same light?"));
  VerifyReport wrong = reportOf(0.98);
  wrong.light.regions.front().excused = report.light.image().excused;
  CHECK_THAT(toJunit(wrong, {.allowsUndecided = true}), Contains("failures=\"1\" skipped=\"0\""));
}

TEST_CASE("a run that is interrupted in its first question reports its device and its time") {
  NoiseRenderer device, reference;
  device.name = "a device";
  const std::atomic<bool> stop = true;
  render::RenderControl control;
  control.stop = &stop;
  render::RenderSettings settings = render::defaultSettings();
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
  CHECK_THAT(toJunit(report, {.strict = true}), Contains("tests=\"3\" failures=\"0\""));
  image::Film film(16, 16);
  film.addSample(3, 4, glm::dvec3(-1), 0);
  render::ImageSettings image;
  image.size = {16, 16};
  report.badSamples.device.add(film, image);
  CHECK_THAT(toJunit(report, {.strict = true}),
             Contains("tests=\"3\" failures=\"1\"") && Contains("<failure type=\"Fail\" message=\"1 bad samples\""));
  CHECK_THAT(toJunit(report, {}), Contains("tests=\"2\" failures=\"0\""));
  CHECK(report.conclusion() == Conclusion::same);
}

}  // namespace
}  // namespace candela::verify
