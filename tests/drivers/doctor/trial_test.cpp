// The test picture: the reference takes the place of right and wrong devices.
#include "host/drivers/doctor/trial.h"

#include <catch2/catch.hpp>

#include "host/trace/reference/reference_renderer.h"

namespace candela::doctor {
namespace {

// Renders with another seed, so that the light is right and the paths are not.
class OtherPaths final : public render::Renderer {
 public:
  std::unique_ptr<render::Session> prepare(const scene::Scene& scene, const render::RenderSettings& settings) override {
    render::RenderSettings other = settings;
    ++other.image.seed;
    return renderer_->prepare(scene, other);
  }

 private:
  std::unique_ptr<render::Renderer> renderer_ = reference::makeReferenceRenderer();
};

}  // namespace

TEST_CASE("a device that renders like the reference works") {
  const std::unique_ptr<render::Renderer> device = reference::makeReferenceRenderer();
  const Trial trial = interpretTrial(compareWithReference(*device));
  CHECK(trial.outcome == TrialOutcome::works);
  CHECK(trial.check.status == Status::ok);
  CHECK(trial.check.remedy.empty());
  CHECK(trial.agreement["report"]["agrees"] == true);
}

TEST_CASE("a device that traces other paths is wrong") {
  OtherPaths device;
  const Trial trial = interpretTrial(compareWithReference(device));
  CHECK(trial.outcome == TrialOutcome::wrong);
  CHECK(trial.check.status == Status::problem);
  CHECK_THAT(trial.check.text, Catch::Contains("DIFFERS"));
  CHECK_FALSE(trial.check.remedy.empty());
}

TEST_CASE("a picture that is not decided is a warning with the reason") {
  const Trial trial = interpretTrial(
      {{"agrees", nullptr}, {"seconds", 1.0}, {"truncated", 0}, {"report", {{"verdict", "Not decided: noise."}}}});
  CHECK(trial.outcome == TrialOutcome::undecided);
  CHECK(trial.check.status == Status::warning);
  CHECK_THAT(trial.check.text, Catch::Contains("Not decided: noise."));
  CHECK_FALSE(trial.check.remedy.empty());
}

TEST_CASE("a device that does not exist fails with the reason") {
  const Trial trial = tryRender("no such device");
  CHECK(trial.outcome == TrialOutcome::fails);
  CHECK_THAT(trial.check.text, Catch::StartsWith("rendering it fails: no Vulkan device"));
  CHECK(trial.agreement.is_null());
}

}  // namespace candela::doctor
