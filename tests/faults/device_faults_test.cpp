// Renders on a device that fails: the layer of this folder makes chosen calls fail.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "host/image/image.h"
#include "tests/app/cli/run_program.h"

namespace candela {
namespace {

constexpr const char* kEveryFrom = "+";

Surroundings withFaults(const std::string& faults) {
  Surroundings surroundings;
  surroundings.environment = {"VK_LAYER_PATH=" CANDELA_FAULT_LAYERS, "VK_INSTANCE_LAYERS=VK_LAYER_CANDELA_faults",
                              "CANDELA_FAULT=" + faults};
  return surroundings;
}

// A render of 32x24 pixels in six tiles.
class Render {
 public:
  ProgramResult run(const std::vector<std::string>& options, const std::string& faults = "") const {
    std::vector<std::string> words{scene_, "--size", "32x24", "--spp", "16", "--max-depth", "5", "--tile", "16x8"};
    words.insert(words.end(), options.begin(), options.end());
    return runCandela(words, faults.empty() ? Surroundings{} : withFaults(faults));
  }
  std::string film(const std::string& name, const std::string& faults = "",
                   std::vector<std::string> options = {}) const {
    options.insert(options.end(), {"--checkpoint", folder.path(name)});
    const ProgramResult result = run(options, faults);
    INFO(result.err);
    CHECK(result.exitCode == 0);
    return readText(folder.path(name));
  }

  /// A call of a function among those of the render's dispatches: the third after as many as a render of one pixel
  /// makes, which opens the device, has one dispatch and reads its result.
  int callAmidDispatches(const std::string& function) const {
    const std::string counts = folder.path("counts");
    Surroundings surroundings = withFaults("");
    surroundings.environment.push_back("CANDELA_FAULT_COUNTS=" + counts);
    const ProgramResult result = runCandela({scene_, "--size", "1x1", "--spp", "1", "-o", folder.path("pixel.pfm")},
                                            surroundings);
    INFO(result.err);
    CHECK(result.exitCode == 0);
    std::istringstream lines(readText(counts));
    int number = 0;
    for (std::string name; lines >> name >> number;) {
      if (name == function) return number + 3;
    }
    FAIL(function);
    return 0;
  }

  const TemporaryFolder folder;

 private:
  std::string scene_ = folder.write("scene.p3f", smallScene());
};

// A wait for a device, as the layer reports it.
struct Wait {
  double seconds = 0;  // the timeout
  bool isOfNewPipeline = false;
};

// Runs a command on devices that claim to be GPUs, and returns its waits.
std::vector<Wait> waitsOf(const std::vector<std::string>& words, const std::string& file) {
  std::filesystem::remove(file);
  Surroundings surroundings = withFaults("");
  surroundings.environment.push_back("CANDELA_FAULT_WAITS=" + file);
  const ProgramResult result = runCandela(words, surroundings);
  INFO(result.err);
  CHECK(result.exitCode == 0);
  std::vector<Wait> waits;
  std::istringstream lines(readText(file));
  for (std::string seconds, kind; lines >> seconds >> kind;) waits.push_back({std::stod(seconds), kind == "new"});
  return waits;
}

std::string fault(const std::string& function, int call, const std::string& result, const std::string& every = "") {
  return function + ":" + std::to_string(call) + every + ":VK_ERROR_" + result;
}

}  // namespace

TEST_CASE("an image whose device fails while it is denoised is denoised by the host") {
  const Render render;
  render.film("film.exr", "", {"--denoise"});
  const std::string film = render.folder.path("film.exr"), a = render.folder.path("a.exr");
  REQUIRE(runCandela({"denoise", film, "-o", a, "--device", "cpu"}).exitCode == 0);
  for (const std::string& faults : {fault("vkWaitForFences", 1, "DEVICE_LOST", kEveryFrom),
                                    fault("vkAllocateMemory", 1, "OUT_OF_DEVICE_MEMORY", kEveryFrom)}) {
    INFO(faults);
    const std::string b = render.folder.path("b.exr");
    const ProgramResult result = runCandela({"denoise", film, "-o", b}, withFaults(faults));
    CHECK(result.exitCode == 0);
    CHECK(contains(result.err, "; the image is denoised on the host instead"));
    CHECK(readText(a) == readText(b));
  }
}

TEST_CASE("a finished render whose device cannot be opened again is denoised by the host") {
  const Render render;
  render.film("film.exr", "", {"--denoise"});
  const std::string film = render.folder.path("film.exr"), a = render.folder.path("a.pfm");
  REQUIRE(runCandela({"denoise", film, "-o", a, "--device", "cpu"}).exitCode == 0);
  for (const char* result : {"INITIALIZATION_FAILED", "DEVICE_LOST", "OUT_OF_HOST_MEMORY"}) {
    INFO(result);
    const std::string b = render.folder.path("b.pfm");
    std::filesystem::remove(b);
    const ProgramResult rendered = render.run({"--denoise", "-o", b}, fault("vkCreateDevice", 2, result, kEveryFrom));
    CHECK(rendered.exitCode == 0);
    CHECK(contains(rendered.err, "; the image is denoised on the host instead"));
    CHECK(readText(b) == readText(a));
  }
  // A film file is not lost with the device.
  const ProgramResult denoised = runCandela(
      {"denoise", film, "-o", a}, withFaults(fault("vkCreateDevice", 1, "INITIALIZATION_FAILED", kEveryFrom)));
  CHECK(denoised.exitCode == 4);
}

TEST_CASE("a render whose device fails once ends with the bytes of one that did not") {
  const Render render;
  const std::string whole = render.film("whole.exr");
  const int submission = render.callAmidDispatches("vkQueueSubmit");
  int index = 0;
  for (const std::string& faults :
       {fault("vkQueueSubmit", submission, "DEVICE_LOST"), fault("vkQueueSubmit", 2, "DEVICE_LOST"),
        fault("vkWaitForFences", render.callAmidDispatches("vkWaitForFences"), "DEVICE_LOST"),
        fault("vkWaitForFences", render.callAmidDispatches("vkWaitForFences"), "OUT_OF_HOST_MEMORY"),
        fault("vkQueueSubmit", submission - 1, "OUT_OF_DEVICE_MEMORY"),
        fault("vkEndCommandBuffer", render.callAmidDispatches("vkEndCommandBuffer"), "UNKNOWN"),
        fault("vkMapMemory", 3, "MEMORY_MAP_FAILED")}) {
    INFO(faults);
    CHECK(render.film("film" + std::to_string(index++) + ".exr", faults, {"--checkpoint-every", "0.01s"}) == whole);
  }
}

TEST_CASE("a device that fails repeatedly ends a render with a film from which it can be resumed") {
  const Render render;
  const std::string whole = render.film("whole.exr");
  const std::string film = render.folder.path("film.exr");
  REQUIRE(render.run({"--samples", "0:4", "--checkpoint", film}).exitCode == 0);
  const ProgramResult lost = render.run(
      {"--checkpoint", film, "--resume", film},
      fault("vkQueueSubmit", render.callAmidDispatches("vkQueueSubmit"), "DEVICE_LOST", kEveryFrom));
  INFO(lost.err);
  CHECK(lost.exitCode == 5);
  CHECK(contains(lost.err, "attempt 3 of 3"));
  CHECK(contains(lost.err, "with --resume " + film + " continues it"));
  const ProgramResult memory = render.run(
      {"--checkpoint", film, "--resume", film},
      fault("vkQueueSubmit", render.callAmidDispatches("vkQueueSubmit"), "OUT_OF_DEVICE_MEMORY", kEveryFrom));
  CHECK(memory.exitCode == 6);
  CHECK(render.film("film.exr", "", {"--resume", film}) == whole);
}

TEST_CASE("a driver that leaves work out without an error ends a render, which can be resumed") {
  const Render render;
  const std::string whole = render.film("whole.exr");
  const std::string film = render.folder.path("film.exr");
  const std::string kernel = GENERATE("megakernel", "wavefront");
  CAPTURE(kernel);
  const ProgramResult stalled = render.run({"--checkpoint", film, "--checkpoint-every", "0.01s", "--time-limit", "60s",
                                            "--kernel", kernel, "--segments-per-dispatch", "2"},
                                           "vkCmdDispatch:60+:DROP_WIDE");
  INFO(stalled.err);
  CHECK(stalled.exitCode == 5);
  CHECK(contains(stalled.err, "reports success, but has traced no path further in 16 dispatches of every pixel"));
  CHECK(contains(stalled.err, "attempt 3 of 3"));
  if (kernel != "megakernel") return;
  CHECK(render.film("film.exr", "", {"--resume", film}) == whole);
}

TEST_CASE("a driver that leaves out the replay of a sample ends `explain`") {
  const Render render;
  const ProgramResult result = runCandela({"explain", render.folder.write("a.p3f", smallScene()), "--pixel", "3,4"},
                                          withFaults("vkCmdDispatch:2+:DROP"));
  INFO(result.err);
  CHECK(result.exitCode == 5);
  CHECK(contains(result.err, "does not trace the sample to its end"));
}

TEST_CASE("a render without a checkpoint leaves a film beside its output") {
  const Render render;
  const std::string whole = render.film("whole.exr");
  const std::string picture = render.folder.path("a.png");
  const std::string film = picture + ".film.exr";
  // The film is read to the host at the end, so that the last calls are made to fail.
  const std::string resumed = render.folder.path("part.exr");
  REQUIRE(render.run({"--samples", "0:4", "--checkpoint", resumed}).exitCode == 0);
  const ProgramResult result = render.run(
      {"--resume", resumed, "-o", picture},
      fault("vkQueueSubmit", render.callAmidDispatches("vkQueueSubmit"), "DEVICE_LOST", kEveryFrom));
  INFO(result.err);
  CHECK(result.exitCode == 5);
  REQUIRE(std::filesystem::exists(film));
  CHECK(image::readImage(picture).width == 32);
  const ProgramResult end = render.run({"--resume", film, "--checkpoint", film});
  CHECK(end.exitCode == 0);
  CHECK(readText(film) == whole);
}

TEST_CASE("`--fallback cpu` finishes a render on the reference, and marks the film") {
  const Render render;
  const std::string film = render.folder.path("film.exr");
  REQUIRE(render.run({"--samples", "0:4", "--checkpoint", film}).exitCode ==
          0);  // a GPU may write none before it fails
  const ProgramResult result = render.run(
      {"--checkpoint", film, "--resume", film, "--fallback", "cpu"},
      fault("vkQueueSubmit", render.callAmidDispatches("vkQueueSubmit"), "DEVICE_LOST", kEveryFrom));
  INFO(result.err);
  REQUIRE(result.exitCode == 0);
  const auto description = nlohmann::json::parse(runCandela({"film", film, "--json", "-"}).out);
  CHECK(description["complete"] == true);
  CHECK(description["mixed"] == true);
  CHECK(description["tracers"].size() == 2);
}

TEST_CASE("a device that hangs ends a render after --hang-timeout") {
  const Render render;
  const std::string whole = render.film("whole.exr");
  const std::string film = render.folder.path("film.exr");
  const ProgramResult result = render.run(
      {"--checkpoint", film, "--checkpoint-every", "0.01s", "--hang-timeout", "10s"},
      "vkWaitForFences:" + std::to_string(render.callAmidDispatches("vkWaitForFences")) + ":HANG");
  INFO(result.err);
  CHECK(result.exitCode == 5);
  CHECK(contains(result.err, "has not finished its work after 10 s; --hang-timeout"));
  CHECK_FALSE(contains(result.err, "attempt"));
  CHECK(render.film("film.exr", "",
                    std::filesystem::exists(film) ? std::vector<std::string>{"--resume", film}
                                                  : std::vector<std::string>{}) == whole);
}

TEST_CASE("the first run of every pipeline may take two minutes, and all others less") {
  const Render render;
  const std::string scene = render.folder.write("small.p3f", smallScene());
  const std::string film = render.folder.path("film.exr");
  REQUIRE(render.run({"--checkpoint", film, "--denoise"}).exitCode == 0);
  const std::vector<std::string> size{"--size", "32x24", "--spp", "2"};
  for (std::vector<std::string> words : {std::vector<std::string>{"render", scene, "-o", render.folder.path("a.png")},
                                         {"render", scene, "-o", render.folder.path("b.png"), "--kernel", "wavefront"},
                                         {"explain", scene, "--pixel", "5,5"},
                                         {"bench", "rays", scene, "--repeat", "1"},
                                         {"denoise", film, "-o", render.folder.path("c.exr")}}) {
    INFO(words.front() << ' ' << words[1]);
    const bool isRender = words.front() != "denoise";
    if (isRender) words.insert(words.end(), size.begin(), size.end());
    const std::vector<Wait> waits = waitsOf(words, render.folder.path("waits"));
    CHECK(std::count_if(waits.begin(), waits.end(), [](const Wait& wait) { return wait.isOfNewPipeline; }) > 0);
    for (const Wait& wait : waits) CHECK((wait.seconds >= 120) == wait.isOfNewPipeline);
  }
}

TEST_CASE("if memory for a band is refused, smaller bands give the same film") {
  const Render render;
  const std::string whole = render.film("whole.exr");
  // The fourth to sixth allocations are those of the first band's buffers.
  for (const int call : {4, 5, 6}) {
    CHECK(render.film("film" + std::to_string(call) + ".exr", fault("vkAllocateMemory", call, "TOO_MANY_OBJECTS")) ==
          whole);
  }
}

}  // namespace candela
