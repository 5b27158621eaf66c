// Renders that are stopped or killed, and resumed from their films, on the reference tracer.
#include <catch2/catch.hpp>
#include <filesystem>
#include <future>
#include <thread>

#include "tests/app/cli/film_runs.h"

namespace candela {
namespace {

using Catch::Contains;
using std::chrono::milliseconds;

// A render of about a second on one thread.
const FilmRuns kLong{{"--device", "cpu", "--threads", "1", "--size", "64x48", "--spp", "256"}};

}  // namespace

TEST_CASE("a film that cannot be written at the end is an error, and the picture is still written") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const std::string gone = folder.path("gone");
  std::filesystem::create_directory(gone);
  const std::string picture = folder.path("a.png");
  // The folder vanishes while the render runs.
  std::jthread thief([&] {
    std::this_thread::sleep_for(milliseconds(150));
    std::filesystem::remove_all(gone);
  });
  const ProgramResult result = kLong.run(scene,
                                         {"-o", picture, "--checkpoint", gone + "/a.exr", "--time-limit", "0.6s"});
  CHECK(result.exitCode == 2);
  CHECK_THAT(result.err, Contains("a.exr"));
  CHECK(std::filesystem::exists(picture));
}

TEST_CASE("a picture that cannot be written does not prevent the other ones and the report") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const std::string picture = folder.path("c.png"), report = folder.path("c.json");
  // A PFM file of this size has 9 KB, and the limit is 8 KiB.
  const ProgramResult result = runProgram(
      "/bin/sh",
      {"-c", "ulimit -f 16 && exec \"$0\" \"$@\"", CANDELA_PROGRAM, scene, "--device", "cpu", "--size", "32x24",
       "--spp", "1", "-o", folder.path("a.pfm"), "-o", folder.path("b.pfm"), "-o", picture, "--json", report});
  CHECK(result.exitCode == 2);
  CHECK_THAT(result.err, Contains("a.pfm\": File too large\ncandela: cannot write") && Contains("b.pfm\": File too"));
  CHECK(std::filesystem::exists(picture));
  CHECK(jsonOf(report).at("schema") == "candela-render/1");
  CHECK(folder.fileCount() == 3);
}

TEST_CASE("a film beyond the limit for files (ulimit -f) is an error, and not the end of the program") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const std::string film = folder.path("a.exr");
  const ProgramResult result = runProgram(
      "/bin/sh", {"-c", "ulimit -f 8 && exec \"$0\" \"$@\"", CANDELA_PROGRAM, scene, "--device", "cpu", "--size",
                  "64x48", "--spp", "1", "--checkpoint", film});
  CHECK(result.exitCode == 2);
  CHECK_THAT(result.err, Contains("a.exr") && Contains("File too large"));
  CHECK(folder.fileCount() == 1);
}

TEST_CASE("a render that is stopped in any way leaves a film from which it can be resumed") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const std::string whole = kLong.film(scene, folder.path("whole.exr"));
  const auto finish = [&](const std::string& film) { CHECK(kLong.film(scene, film, {"--resume", film}) == whole); };
  SECTION("by --time-limit") {
    const std::string film = folder.path("a.exr");
    const ProgramResult result = kLong.run(scene, {"--checkpoint", film, "--time-limit", "0.2s"});
    CHECK(result.exitCode == 7);
    CHECK_THAT(result.err, Contains("the time limit is reached") && Contains("--resume " + film));
    CHECK_THAT(result.err,
               Contains("64x48 pixels, stopped by --time-limit after ") && Contains(" of 256 samples per pixel"));
    const ProgramResult description = runCandela({"film", film});
    CHECK_THAT(description.out, Contains("interrupted in"));
    finish(film);
  }
  SECTION("by Ctrl-C, by SIGTERM, by SIGHUP and by SIGXCPU") {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGXCPU}) {
      const std::string film = folder.path(std::to_string(signal) + ".exr");
      Surroundings surroundings;
      surroundings.interruptAfter = milliseconds(200);
      surroundings.signal = signal;
      const ProgramResult result = kLong.run(scene, {"--checkpoint", film}, surroundings);
      CHECK(result.exitCode == 7);
      CHECK_THAT(result.err, Contains("64x48 pixels, interrupted after ") && Contains(" of 256 samples per pixel"));
      finish(film);
    }
  }
}

TEST_CASE("a render whose processor time is limited (ulimit -t) ends with its film before it is killed") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const std::string film = folder.path("a.exr");
  const ProgramResult result = runProgram(
      "/bin/sh", {"-c", "ulimit -t 2; exec " CANDELA_PROGRAM " " + scene + " --device cpu --threads 1 --size 64x48 " +
                            "--spp 10000000 --time-limit 1min --checkpoint " + film});
  CHECK(result.exitCode == 7);
  CHECK_THAT(result.err, Contains("the limit of processor time (ulimit -t) is reached"));
  CHECK(runCandela({"film", film}).exitCode == 0);
}

TEST_CASE("a render whose outputs nobody reads any more finishes, and says so by its exit code") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const std::string whole = kLong.film(scene, folder.path("whole.exr"));
  const std::string film = folder.path("a.exr"), code = folder.path("code");
  const std::string render = "{ sleep 0.2; " CANDELA_PROGRAM " " + scene +
                             " --device cpu --threads 1 --size 64x48 --spp 256 -v " + "--checkpoint " + film + " -o " +
                             folder.path("a.png") + " --json - ";
  SECTION("stdout: exit code 2") {
    const ProgramResult result = runProgram("/bin/sh", {"-c", render + "; echo $? > " + code + "; } | true"});
    CHECK(readText(code) == "2\n");
    CHECK_FALSE(contains(result.err, "cannot write"));
  }
  SECTION("stderr: as if somebody read it") {
    runProgram("/bin/sh", {"-c", render + "2>&3; echo $? > " + code + "; } 3>&1 >" + folder.path("out") + " | true"});
    CHECK(readText(code) == "0\n");
    CHECK(nlohmann::json::parse(readText(folder.path("out"))).contains("filmHash"));
  }
  CHECK(readText(film) == whole);
  CHECK(std::filesystem::exists(folder.path("a.png")));
}

TEST_CASE("a command whose text nobody reads ends without a message, and one that cannot write it with one") {
  const std::string ends = " echo $? >&2; } | true";
  for (const std::string command : {"generate balls --size 4", "conformance --list", "--help"}) {
    INFO(command);
    const ProgramResult closed = runProgram("/bin/sh",
                                            {"-c", "{ sleep 0.1; " CANDELA_PROGRAM " " + command + ";" + ends});
    CHECK(closed.err == "2\n");
    const ProgramResult full = runProgram("/bin/sh", {"-c", CANDELA_PROGRAM " " + command + " > /dev/full"});
    CHECK(full.exitCode == 2);
    CHECK_THAT(full.err, Contains("cannot write to stdout"));
  }
}

TEST_CASE("a film that another render is writing is neither written nor resumed by a second one") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const std::string film = folder.path("a.exr"), other = folder.path("b.exr"), done = folder.path("done.exr");
  kLong.film(scene, done);
  const std::vector<std::string> options{"--checkpoint", film, "--spp", "10000000", "--time-limit", "4s"};
  auto first = std::async(std::launch::async, [&] { return kLong.run(scene, options); });
  for (int i = 0; i < 400 && !std::filesystem::exists(film + ".candela-lock"); ++i) {
    std::this_thread::sleep_for(milliseconds(5));
  }
  const auto refused = Contains("a.exr: another render is writing this film");
  CHECK_THAT(kLong.refusal(scene, {"--checkpoint", film}), refused);
  CHECK_THAT(kLong.refusal(scene, {"--resume", film, "--checkpoint", other}), refused);
  const ProgramResult merged = runCandela({"merge", done, "-o", film});
  CHECK(merged.exitCode == 2);
  CHECK_THAT(merged.err, refused);
  CHECK(first.get().exitCode == 7);
  CHECK(runCandela({"film", film}).exitCode == 0);
  CHECK(folder.fileCount() == 5);  // the scene, and two films with their reports
}

TEST_CASE("SIGUSR1 writes the film each time, and changes nothing") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const std::string whole = kLong.film(scene, folder.path("whole.exr"));
  Surroundings surroundings;
  surroundings.writeRequestsFrom = milliseconds(100);
  surroundings.writeRequestsEvery = milliseconds(40);
  const std::string film = folder.path("a.exr");
  const ProgramResult result = kLong.run(scene, {"--checkpoint", film, "--checkpoint-every", "1h", "-v"}, surroundings);
  CHECK(result.exitCode == 0);
  CHECK(readText(film) == whole);
  std::size_t writes = 0;
  for (std::size_t at = 0; (at = result.err.find("a.exr: written after", at)) != std::string::npos; ++at) ++writes;
  CHECK(writes >= 3);
  CHECK(folder.fileCount() == 5);  // the scene, and two films with their reports
}

TEST_CASE("SIGUSR1 does not end a render without a film file, which says so") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  Surroundings surroundings;
  surroundings.interruptAfter = milliseconds(300);
  surroundings.signal = SIGUSR1;
  const ProgramResult result = kLong.run(scene, {"-o", folder.path("a.png")}, surroundings);
  CHECK(result.exitCode == 0);
  CHECK_THAT(result.err, Contains("SIGUSR1 was ignored") && Contains("--checkpoint"));
}

TEST_CASE("a render that is killed at any moment resumes from its checkpoint to the same bytes") {
  requireSurvivesKills(kLong, 10, 1);
}

TEST_CASE("a render that is killed at 200 even and 100 random moments resumes from its checkpoint", "[slow]") {
  requireSurvivesKills(kLong, 200, 1);
  requireSurvivesKills(kLong, 0, 100);
}

}  // namespace candela
