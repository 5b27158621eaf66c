// Rates and percentiles, compared with values computed by hand, and the documented keys.
#include "host/app/cli/statistics_report.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/trace/reference/default_settings.h"

namespace candela::cli {
namespace {

RenderJob madeJob() { return {{std::make_shared<scene::Scene>(), {}, render::defaultSettings()}}; }

render::RenderResult exampleResult() {
  render::RenderResult result;
  result.film = image::Film(2, 2);
  render::RenderStatistics& statistics = result.statistics;
  statistics.samples = 4'000'000;
  statistics.cameraRays = 4'000'000;
  statistics.bounceRays = 5'000'000;
  statistics.shadowRays = 3'000'000;
  statistics.vertices = 8'000'000;
  statistics.seconds["trace"] = 2;
  statistics.seconds["build"] = 0.25;
  for (int i = 100; i >= 1; --i) statistics.dispatchSeconds.push_back(i);
  statistics.workgroup = {16, 4};
  statistics.automaticOrigin = "tuned";
  statistics.structure = render::AccelKind::bvh;
  return result;
}

}  // namespace

TEST_CASE("rates are per second of tracing") {
  const render::RenderResult result = exampleResult();
  const auto json = toJson(RenderReport{madeJob(), result, 0.5, 4});
  CHECK(json["msamplesPerSecond"] == 2.0);
  CHECK(json["mraysPerSecond"] == 6.0);
  CHECK(json["verticesPerSample"] == 2.0);
  CHECK(json["phaseSeconds"]["trace"] == 2.0);
  CHECK(json["phaseSeconds"]["write"] == 0.5);
  CHECK(json["phaseSeconds"]["total"] == 4.0);
  CHECK(json["workgroup"] == "16x4");
  CHECK(json["auto"] == "tuned");
}

TEST_CASE("the choices in use have their names on the command line, and empty texts where there is none") {
  using namespace render;
  RenderResult result = exampleResult();
  const auto names = [&] {
    const auto json = toJson(RenderReport{madeJob(), result, 0, 0});
    std::vector<std::string> texts;
    for (const char* key : {"structure", "bvhSplit", "bvhQuality", "layout", "kernel", "sceneLoads"}) {
      texts.push_back(json[key]);
    }
    return texts;
  };
  using Names = std::vector<std::string>;
  CHECK(names() == Names{"bvh", "", "", "", "reference", ""});
  RenderStatistics& statistics = result.statistics;
  const auto use = [&](AccelKind accel, SplitInUse split, BuildQuality quality, LayoutInUse layout, KernelInUse kernel,
                       SceneLoads loads) {
    statistics.structure = accel;
    statistics.bvhSplit = split;
    statistics.bvhQuality = quality;
    statistics.layout = layout;
    statistics.kernel = kernel;
    statistics.sceneLoads = loads;
    return names();
  };
  CHECK(use(AccelKind::none, SplitInUse::sah, BuildQuality::fast, LayoutInUse::list, KernelInUse::megakernel,
            SceneLoads::texel) == Names{"none", "sah", "fast", "list", "megakernel", "texel"});
  CHECK(use(AccelKind::grid, SplitInUse::midpoint, BuildQuality::standard, LayoutInUse::bvh2, KernelInUse::wavefront,
            SceneLoads::storage) == Names{"grid", "midpoint", "default", "bvh2", "wavefront", "storage"});
  CHECK(use(AccelKind::bvh, SplitInUse::median, BuildQuality::high, LayoutInUse::cwbvh, KernelInUse::whitted,
            SceneLoads::texel) == Names{"bvh", "median", "high", "cwbvh", "whitted", "texel"});
  statistics.kernel = KernelInUse::views;
  CHECK(names()[4] == "views");
}

TEST_CASE("rays of the Whitted tracer are reported by kind, those of paths are not") {
  render::RenderResult result = exampleResult();
  CHECK_FALSE(toJson(RenderReport{madeJob(), result, 0, 0})["rays"].contains("reflected"));
  result.statistics.treeRays = {.cameraHits = 3, .reflected = 4, .refracted = 1};
  const auto rays = toJson(RenderReport{madeJob(), result, 0, 0})["rays"];
  CHECK(rays["cameraHits"] == 3);
  CHECK(rays["reflected"] == 4);
  CHECK(rays["refracted"] == 1);
  CHECK(rays["total"] == 12'000'000);
}

TEST_CASE("dispatch times are reported in seconds") {
  const render::RenderResult result = exampleResult();
  const auto dispatch = toJson(RenderReport{madeJob(), result, 0, 0})["dispatches"];
  CHECK(dispatch["count"] == 100);
  CHECK(dispatch["medianSeconds"] == 50.5);
  CHECK(dispatch["p99Seconds"] == 99.0);
  CHECK(dispatch["maxSeconds"] == 100.0);
}

TEST_CASE("the report of a render without samples divides nothing by 0") {
  const auto json = toJson(RenderReport{madeJob(), render::RenderResult{}, 0, 0});
  CHECK(json["msamplesPerSecond"] == 0.0);
  CHECK(json["verticesPerSample"] == 0.0);
  CHECK(json["dispatches"]["medianSeconds"] == 0.0);
}

TEST_CASE("faults of volumes are reported where they are too many for rounding") {
  render::RenderResult result = exampleResult();
  const auto reported = [&](std::uint64_t faults, Verbosity verbosity) {
    result.statistics.volumeFaults = faults;
    std::ostringstream sink;
    reportFlaws(RenderReport{madeJob(), result, 0, 0}, Log(sink, verbosity));
    return sink.str();
  };
  CHECK(reported(0, Verbosity::verbose).empty());
  CHECK(reported(400, Verbosity::normal).empty());
  CHECK(reported(1, Verbosity::verbose).find("1 ray entered") != std::string::npos);
  CHECK(reported(400, Verbosity::verbose).find("0.01 % of the samples: probably rounding") != std::string::npos);
  CHECK(reported(8000, Verbosity::normal)
            .find("8000 rays (0.2 % of the samples) hit volumes that are not closed, or that overlap or contain each "
                  "other; each surface refracts as if it bordered on air, and only the volume that a ray entered last "
                  "absorbs") != std::string::npos);
}

TEST_CASE("settings are typed: numbers, words and flags") {
  RenderJob job = madeJob();
  job.settings.image.oneSided = true;
  job.settings.image.seed = 4294967295u;
  const auto settings = toJson(RenderReport{job, render::RenderResult{}, 0, 0})["settings"];
  CHECK(settings["maxDepth"] == 64);
  CHECK(settings["seed"] == 4294967295u);
  CHECK(settings["oneSided"] == true);
  CHECK(settings["lenient"] == false);
  CHECK(settings["sampler"] == "sobol");
  CHECK(settings["samplesPerPixel"] == 16);
  CHECK(settings["time"].is_null());
}

TEST_CASE("the text report has every figure of the JSON report") {
  const render::RenderResult result = exampleResult();
  const std::string text = toText(RenderReport{madeJob(), result, 0, 0});
  CHECK(text.find("mraysPerSecond                   6\n") != std::string::npos);
  CHECK(text.find("phaseSeconds.trace               2\n") != std::string::npos);
  CHECK(text.find("structure                        bvh\n") != std::string::npos);
}

}  // namespace candela::cli
