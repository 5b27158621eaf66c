// The messages about bad samples, and the command that replays one.
#include "host/app/cli/bad_samples.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/trace/reference/default_settings.h"

namespace candela::cli {
namespace {

const render::BadPixel kPixel{.x = 2, .y = 1, .badCount = 2, .firstSample = 5, .seed = 9, .sampleCount = 64};

RenderJob jobWith(render::Integrator integrator, render::SamplerKind sampler) {
  RenderJob job{{std::make_shared<scene::Scene>(), {}, render::defaultSettings()}};
  job.arguments.files = {"a scene.p3f"};
  job.settings.image.size = {3, 2};
  job.settings.image.sampleCount = 64;
  job.settings.image.integrator = integrator;
  job.settings.image.sampler = sampler;
  return job;
}

render::BadSampleTally tallyOfOne() {
  image::Film film(3, 2);
  film.addSample(2, 1, glm::dvec3(1e9), 5);
  film.addSample(2, 1, glm::dvec3(1e9), 6);
  render::RenderSettings settings = render::defaultSettings();
  settings.image.size = {3, 2};
  settings.image.seed = 9;
  settings.image.sampleCount = 64;
  render::BadSampleTally tally;
  tally.add(film, settings.image);
  return tally;
}

}  // namespace

TEST_CASE("a path's bad sample is replayed by `explain` with every option on which it depends") {
  const RenderJob job = jobWith(render::Integrator::path, render::SamplerKind::sobol);
  CHECK(replayCommand(kPixel, job) ==
        "candela explain 'a scene.p3f' --seed 9 --size 3x2 --max-depth 64 --lights power --filter box --accel bvh "
        "--spp 64 --pixel "
        "2,1 --sample 5");
  const RenderJob strata = jobWith(render::Integrator::path, render::SamplerKind::stratified);
  CHECK(replayCommand(kPixel, strata) ==
        "candela explain 'a scene.p3f' --seed 9 --size 3x2 --max-depth 64 --lights power --sampler stratified --filter "
        "box --accel bvh --spp 64 "
        "--pixel 2,1 --sample 5");
}

TEST_CASE("a bad sample of the reference is explained on the default device, that of a device on the device") {
  RenderJob job = jobWith(render::Integrator::path, render::SamplerKind::sobol);
  job.arguments.device = "cpu";
  CHECK_THAT(replayCommand(kPixel, job), !Catch::Contains("--device"));
  job.arguments.device = "llvmpipe";
  CHECK_THAT(replayCommand(kPixel, job), Catch::Contains("--device llvmpipe"));
}

TEST_CASE("the replay of an integrator without paths renders the image up to the bad sample, with the same jitter") {
  for (const auto& [integrator, name] :
       {std::pair(render::Integrator::whitted, "whitted"), {render::Integrator::depth, "depth"}}) {
    const RenderJob job = jobWith(integrator, render::SamplerKind::sobol);
    const std::string start = "candela render 'a scene.p3f' --seed 9 --size 3x2 --max-depth 64 --integrator " +
                              std::string(name) + " --lights power";
    CHECK(replayCommand(kPixel, job) == start + " --filter box --accel bvh --spp 6 -o replay.exr");
    render::BadPixel other = kPixel;
    other.firstSample = 0;
    CHECK(replayCommand(other, job) == start + " --filter box --accel bvh --spp 2 -o replay.exr");
    other.sampleCount = 1;
    CHECK(replayCommand(other, job) == start + " --filter box --accel bvh --spp 1 -o replay.exr");
    CHECK(replayCommand(kPixel, jobWith(integrator, render::SamplerKind::stratified)) ==
          start + " --sampler stratified --filter box --accel bvh --spp 64 -o replay.exr");
  }
}

TEST_CASE("bad samples are reported with their number, their pixels and a replay") {
  const RenderJob job = jobWith(render::Integrator::path, render::SamplerKind::sobol);
  CHECK(badSampleLines({}, job).empty());
  const std::vector<std::string> lines = badSampleLines(tallyOfOne(), job);
  REQUIRE(lines.size() == 2);
  CHECK(lines[0] ==
        "bad samples: 2 samples in 1 pixel, not finite or negative (they count as 0) or above 2^20 (they are clamped; "
        "--film-scale raises this limit)");
  CHECK(lines[1] == "pixel (2, 1): 2 bad, the first is sample 5; replay: " + replayCommand(kPixel, job));

  const nlohmann::ordered_json json = badSamplesJson({tallyOfOne(), {}}, job);
  CHECK(json["device"]["samples"] == 2);
  CHECK(json["device"]["pixels"] == 1);
  CHECK(json["device"]["firstPixels"][0]["firstSample"] == 5);
  CHECK(json["device"]["firstPixels"][0]["replay"] == replayCommand(kPixel, job));
  CHECK(json["reference"]["samples"] == 0);
  CHECK(json["reference"]["firstPixels"].empty());
}

TEST_CASE("the option --strict turns success and doubt with bad samples into exit code 3 and changes no other code") {
  std::ostringstream sink;
  const Log log(sink, Verbosity::quiet);
  StrictArguments arguments;
  CHECK(strictly(ExitCode::done, 4, arguments, log) == ExitCode::done);
  arguments.strict = true;
  CHECK(strictly(ExitCode::done, 0, arguments, log) == ExitCode::done);
  CHECK(sink.str().empty());
  CHECK(strictly(ExitCode::done, 4, arguments, log) == ExitCode::differ);
  CHECK(sink.str() == "candela: --strict: the run fails because of 4 bad samples; its files are still written\n");
  CHECK(strictly(ExitCode::undecided, 4, arguments, log) == ExitCode::differ);
  CHECK(strictly(ExitCode::interrupted, 4, arguments, log) == ExitCode::interrupted);
}

}  // namespace candela::cli
