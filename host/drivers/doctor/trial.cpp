// Renders a small picture on a device and checks it against the reference tracer.
#include "host/drivers/doctor/trial.h"

#include <fmt/format.h>

#include "embedded/cornell.h"
#include "host/base/setting_words.h"
#include "host/base/stopwatch.h"
#include "host/drivers/child_process.h"
#include "host/formats/nff/nff_loader.h"
#include "host/judge/verify/agreement.h"
#include "host/judge/verify/light_test.h"
#include "host/trace/device/gpu_renderer.h"
#include "host/trace/reference/reference_renderer.h"
#include "host/trace/render/request.h"

namespace candela::doctor {
namespace {

constexpr const char* kName = "test picture";
constexpr std::uint32_t kSide = 48;
constexpr std::uint32_t kSamples = 16;

Trial failed(const std::string& failure) {
  return {
      TrialOutcome::fails,
      {kName, Status::problem, "rendering it " + failure,
       fmt::format("update the driver, or choose another device; `{}` needs no driver", settingWords("device", "cpu"))},
      {}};
}

}  // namespace

nlohmann::json compareWithReference(render::Renderer& device) {
  const scene::Scene scene = scene::parseScene(std::string(embedded::cornell), "the Cornell box", ".").scene;
  render::RenderRequest request;
  request.size = render::Extent{kSide, kSide};
  request.sampleCount = kSamples;
  const std::unique_ptr<render::Renderer> reference = reference::makeReferenceRenderer();
  Stopwatch stopwatch;
  const verify::AgreementReport report = verify::compareTracers(scene, render::resolve(request, scene), device,
                                                                *reference, {}, {});
  const bool isTruncated = report.deviceStatistics.truncated > 0;
  return {{"agrees", isTruncated ? nlohmann::json(false) : nlohmann::json(agreesJson(report.conclusion()))},
          {"seconds", stopwatch.lap()},
          {"truncated", report.deviceStatistics.truncated},
          {"report", nlohmann::json(report.toJson())}};
}

Trial interpretTrial(const nlohmann::json& comparison) {
  Trial trial{TrialOutcome::works, {kName, Status::ok, "", ""}, comparison};
  const std::string what = fmt::format("{}x{} pixels, {} samples, {:.1f} s", kSide, kSide, kSamples,
                                       comparison["seconds"].get<double>());
  trial.check.text = fmt::format("{}: agrees with the reference tracer", what);
  if (comparison["agrees"].is_null()) {
    trial.outcome = TrialOutcome::undecided;
    trial.check.status = Status::warning;
    trial.check.text = fmt::format("{}: {}", what, comparison["report"]["verdict"].get<std::string>());
    trial.check.remedy = "`candela verify SCENE` renders more samples of a scene of yours";
    return trial;
  }
  if (comparison["agrees"].get<bool>()) return trial;
  trial.outcome = TrialOutcome::wrong;
  trial.check.status = Status::problem;
  trial.check.text = fmt::format("{}: DIFFERS from the reference tracer", what);
  trial.check.remedy =
      "update the driver, or choose another device; `candela explain SCENE` shows the "
      "first difference";
  return trial;
}

Trial tryRender(const std::string& selector) {
  const process::ChildResult result = process::runInChild(kTrialLimit, [&] {
    const std::unique_ptr<render::Renderer> device = device::makeGpuRenderer(selector);
    return compareWithReference(*device);
  });
  return result.failure.empty() ? interpretTrial(result.answer) : failed(result.failure);
}

}  // namespace candela::doctor
