// Jobs on made devices that fail: what the film contains, and what reaches its file.
#include "host/job/run_job.h"

#include <catch2/catch.hpp>
#include <sstream>

#include "host/formats/nff/nff_loader.h"
#include "host/job/film/film_file.h"
#include "host/job/film_identity.h"
#include "host/trace/reference/reference_renderer.h"
#include "host/trace/render/request.h"
#include "tests/base/temporary_folder.h"
#include "tests/job/forwarding_session.h"

namespace candela::job {
namespace {

constexpr const char* kScene =
    "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 40\nhither 1\nresolution 12 9\nl 2 3 4\nf 1 0.5 0.2 1 0 0 0 1\n"
    "s 0 0 0 1\n";

Job jobOf(std::uint32_t sampleCount, FilmPolicy film = {}) {
  auto scene = std::make_shared<const scene::Scene>(scene::parseScene(kScene, "ball.nff", ".").scene);
  render::RenderRequest request;
  request.sampleCount = sampleCount;
  request.execution.threads = 1;
  render::RenderSettings settings = render::resolve(request, *scene);
  return {scene, {}, std::move(settings), std::move(film)};
}

/// A session of the reference that is lost at the end of its first step if it must fail.
class LosingSession final : public ForwardingSession {
 public:
  LosingSession(std::unique_ptr<render::Session> inner, bool fails)
      : ForwardingSession(std::move(inner)), fails_(fails) {}

  bool advance(render::SampleRange range, const render::RenderControl& control) override {
    if (!fails_) return ForwardingSession::advance(range, control);
    ForwardingSession::advance({range.first, (range.first + range.end) / 2}, control);
    throw DeviceLostError("the made device was lost");
  }

 private:
  bool fails_;
};

class LosingRenderer final : public render::Renderer {
 public:
  explicit LosingRenderer(bool fails) : fails_(fails) {}
  std::unique_ptr<render::Session> prepare(const scene::Scene& scene, const render::RenderSettings& settings) override {
    return std::make_unique<LosingSession>(reference_->prepare(scene, settings), fails_);
  }

 private:
  std::unique_ptr<render::Renderer> reference_ = reference::makeReferenceRenderer();
  bool fails_;
};

/// Opens devices of which the first `failures` are lost.
OpenDevice losing(int failures) {
  return [left = failures]() mutable { return std::make_unique<LosingRenderer>(left-- > 0); };
}

JobResult run(const Job& job, const OpenDevice& open, std::string* messages = nullptr) {
  std::ostringstream sink;
  JobResult result = runJob(job, open, {}, Log(sink, Verbosity::normal));
  if (messages != nullptr) *messages = sink.str();
  return result;
}

std::uint64_t expectedHash(std::uint32_t sampleCount) {
  const Job job = jobOf(sampleCount);
  return reference::makeReferenceRenderer()->render(job.scene(), job.settings, {}).film.hash();
}

}  // namespace

TEST_CASE("a job without a device has the film of the reference") {
  const JobResult result = run(jobOf(8), {});
  CHECK(result.result.film.hash() == expectedHash(8));
  CHECK(result.header.isComplete());
  CHECK(result.header.tracers.front().device == "cpu");
  CHECK_FALSE(result.work);
  CHECK_FALSE(result.failure);
}

TEST_CASE("a film that is stopped in parts and resumed has the bytes of one that is not") {
  const TemporaryFolder folder;
  const auto whole = folder / "whole.exr", parts = folder / "parts.exr";
  run(jobOf(8, {.checkpoint = whole}), {});
  run(jobOf(3, {.checkpoint = parts}), {});
  const JobResult result = run(jobOf(8, {.checkpoint = parts, .resume = parts}), {});
  CHECK(result.result.film.hash() == expectedHash(8));
  CHECK(result.work->runs == 2);
  CHECK(film::FilmReader(whole).check() == film::FilmReader(parts).check());
}

TEST_CASE("a device that is lost is opened again, and the film has no sample twice") {
  std::string messages;
  const JobResult result = run(jobOf(8), losing(2), &messages);
  CHECK(result.result.film.hash() == expectedHash(8));
  CHECK_FALSE(result.failure);
  CHECK_THAT(messages, Catch::Contains("the made device was lost; the device is opened again (attempt 2 of 3)"));
}

TEST_CASE("the reference finishes the film of a device that fails for good") {
  std::string messages;
  const JobResult result = run(jobOf(8, {.fallback = Fallback::reference}), losing(9), &messages);
  CHECK(result.result.film.hash() == expectedHash(8));
  CHECK_FALSE(result.failure);
  CHECK_THAT(messages, Catch::Contains("the made device was lost; the reference tracer finishes the render"));
}

TEST_CASE("without another tracer, the samples of a device that fails for good are rescued beside the output") {
  const TemporaryFolder folder;
  const auto rescued = folder / "picture.png.film.exr";
  const JobResult result = run(jobOf(8, {.rescueBeside = folder / "picture.png"}), losing(9));
  REQUIRE(result.failure);
  CHECK(result.failure->code == ExitCode::deviceLost);
  CHECK(result.result.interrupted);
  CHECK_FALSE(result.isFilmLost);
  // The remedy names settings, and not the options of a command line.
  CHECK_THAT(result.failure->message, Catch::Contains(rescued.string() + " contains the samples so far") &&
                                          Catch::Contains("resume = " + rescued.string()) &&
                                          Catch::Contains("fallback = cpu") && !Catch::Contains("--"));
  film::FilmReader reader(rescued);
  CHECK(film::readFilm(reader).hash() == result.result.film.hash());
  const JobResult finished = run(jobOf(8, {.resume = rescued}), {});
  CHECK(finished.result.film.hash() == expectedHash(8));
}

TEST_CASE("a render with other settings does not resume a film, and the message names the setting that differs") {
  const TemporaryFolder folder;
  const auto file = folder / "film.exr";
  run(jobOf(4, {.checkpoint = file}), {});
  Job other = jobOf(8, {.resume = file});
  other.settings.image.seed = 5;
  other.settings.image.oneSided = true;
  CHECK_THROWS_WITH(run(other, {}), Catch::Contains("use seed = 0, and leave out one-sided; resume-anyway"));
  other.film.resumeAnyway = true;
  CHECK(run(other, {}).header.mixed.size() == 2);

  // A name that begins like the words of a default is a name.
  const auto named = folder / "named.exr";
  Job first = jobOf(4, {.checkpoint = named});
  first.reading.camera = "the left one";
  run(first, {});
  CHECK_THROWS_WITH(run(jobOf(8, {.resume = named}), {}),
                    Catch::Contains("; use camera = the left one; resume-anyway"));
  first.reading.camera = "right";
  first.film = {.resume = file};
  CHECK_THROWS_WITH(run(first, {}), Catch::Contains("; leave out camera; resume-anyway"));
}

}  // namespace candela::job
