// `candela conformance` as a newcomer uses it, without a device.
#include <catch2/catch.hpp>
#include <sstream>

#include "tests/app/cli/run_program.h"

namespace candela {
namespace {

const Surroundings kNoDriver{
    .environment = {"VK_DRIVER_FILES=/nonexistent/none.json", "VK_ICD_FILENAMES=/nonexistent/none.json"}};

ProgramResult runConformance(const std::vector<std::string>& options) {
  std::vector<std::string> words{"conformance"};
  words.insert(words.end(), options.begin(), options.end());
  return runCandela(words, kNoDriver);
}

}  // namespace

TEST_CASE("conformance --list prints the names without a device") {
  const ProgramResult all = runConformance({"--list"});
  CHECK(all.exitCode == 0);
  CHECK(contains(all.out, "kernel.megakernel.layout.cwbvh.texel.cornell\n"));
  CHECK(contains(all.out, "control.loop.ended_in_the_middle\n"));
  CHECK(runConformance({"--list", "--cases", "leaf.film.*"}).out == "leaf.film.sums\nleaf.film.carry\n");
}

TEST_CASE("conformance runs the cases of all patterns, each once, and each pattern must have a case") {
  const std::string sums = "leaf.film.sums", carry = "leaf.film.carry";
  CHECK(runConformance({"--list", "--cases", carry, "--cases", "leaf.film.*", "--cases", sums}).out ==
        sums + "\n" + carry + "\n");
  const ProgramResult refused = runConformance({"--list", "--cases", "nothing.*", "--cases", sums});
  CHECK(refused.exitCode == 1);
  CHECK(contains(refused.err, "--cases nothing.*: no case has such a name"));
}

TEST_CASE("the page of the cases lists all names") {
  const std::string page = readText(std::string(CANDELA_SOURCE_DIR) + "/docs/conformance-cases.md");
  std::istringstream names(runConformance({"--list"}).out);
  std::size_t count = 0;
  for (std::string name; std::getline(names, name); ++count) {
    INFO(name);
    CHECK(contains(page, "\n| `" + name + "` |"));
  }
  std::size_t rows = 0;
  for (std::size_t at = page.find("\n| `"); at != std::string::npos; at = page.find("\n| `", at + 1)) ++rows;
  CHECK(rows == count);
}

TEST_CASE("a baseline with a name that no case has causes a warning") {
  const TemporaryFolder folder;
  const std::string baseline = folder.write("fails.txt", "control.loop.iteration,Fail\nleaf.film.sums,Fail\n");
  const ProgramResult result = runConformance({"--baseline", baseline});
  CHECK(contains(result.err, baseline + ": there is no case control.loop.iteration; did you mean "
                                        "control.loop.iterations?\n"));
  CHECK_FALSE(contains(result.err, "leaf.film.sums"));
}

TEST_CASE("conformance refuses what it cannot do, and says what to do instead") {
  struct Refusal {
    std::vector<std::string> words;
    int exitCode;
    const char* message;
  };
  const TemporaryFolder folder;
  const std::string wrong = folder.write("wrong.txt", "control.loop.iterations\n");
  const std::string passing = folder.write("passing.txt", "control.loop.iterations,Passes\n");
  const std::string failing = folder.write("failing.txt", "leaf.film.sums,Fail\n");
  const std::string timeouts = folder.write("timeouts.txt", "leaf.film.sums,Timeout\n");
  for (const Refusal& refusal :
       std::vector<Refusal>{{{"--cases", "nothing.*"}, 1, "--cases nothing.*: no case has such a name"},
                            {{"--device", "cpu"}, 1, "choose a Vulkan device"},
                            {{"--jobs", "0"}, 1, "--jobs"},
                            {{"--alpha", "0"}, 1, "--alpha"},
                            {{"--seed", "4294967296"}, 1, "--seed"},
                            {{"--timeout", "soon"}, 1, "--timeout"},
                            {{"scene.p3f"}, 1, "scene.p3f"},
                            {{"--baseline", "/nonexistent/fails.txt"}, 2, "/nonexistent/fails.txt"},
                            {{"--baseline", wrong}, 2, "wrong.txt:1: expected `case,Result`"},
                            {{"--baseline", passing}, 2, "expected Fail, Crash, Timeout, Pass or ExpectedFail"},
                            {{"--baseline", failing, "--baseline", wrong}, 2, "wrong.txt:1"},
                            {{"--baseline", wrong, "--baseline", failing}, 2, "wrong.txt:1"},
                            {{"--baseline", failing, "--baseline", timeouts}, 2, "another result of leaf.film.sums"},
                            {{"--skips", wrong, "--skips", "/nonexistent/skips.txt"}, 2, "/nonexistent/skips.txt"},
                            {{"--skips", "/nonexistent/skips.txt", "--skips", wrong}, 2, "/nonexistent/skips.txt"},
                            {{"--flakes", "/nonexistent/flakes.txt", "--flakes", wrong}, 2, "/nonexistent/flakes.txt"},
                            {{"--csv", "/nonexistent/results.csv"}, 2, "/nonexistent"},
                            {{"--compile-only", "--capture", "captures"}, 1, "--capture: this option applies only"},
                            {{"--compile-only", "--seed", "1"}, 1, "--seed: this option applies only"},
                            {{}, 4, "apt-get install mesa-vulkan-drivers"}}) {
    const ProgramResult result = runConformance(refusal.words);
    INFO(result.err);
    CHECK(result.exitCode == refusal.exitCode);
    CHECK(contains(result.err, refusal.message));
  }
}

}  // namespace candela
