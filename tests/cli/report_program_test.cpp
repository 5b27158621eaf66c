// `candela check`, `candela devices`, and the behaviour without a device.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/cli/run_program.h"

namespace candela {
namespace {

using nlohmann::json;

// The surroundings of a machine without any Vulkan driver.
const Surroundings kNoDriver{{"VK_DRIVER_FILES=/nonexistent", "VK_ICD_FILENAMES=/nonexistent"}, "", {}};

}  // namespace

TEST_CASE("check describes the content of a scene") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const ProgramResult text = runCandela({"check", scene});
  CHECK(text.exitCode == 0);
  CHECK(contains(text.out, "spheres 2"));
  const ProgramResult result = runCandela({"check", scene, "--json", "-"});
  const json entry = json::parse(result.out)["files"][0];
  CHECK(entry["valid"] == true);
  CHECK(entry["file"] == scene);
  CHECK(entry["errors"].empty());
  CHECK(entry["report"]["primitives"]["spheres"] == 2);
}

TEST_CASE("check reads every file, lists all errors, and exits with 2") {
  const TemporaryFolder folder;
  const std::string broken = folder.write("broken.p3f", smallScene("spehre 0 0 0 1\ns 0 0 x 1\n"));
  const std::string whole = folder.write("whole.p3f", smallScene());
  const ProgramResult result = runCandela({"check", broken, folder.path("missing.p3f"), whole, "--json", "-"});
  CHECK(result.exitCode == 2);
  CHECK(contains(result.err, "broken.p3f:18:1: "));
  CHECK(contains(result.err, "broken.p3f:19:7: "));
  const json files = json::parse(result.out)["files"];
  REQUIRE(files.size() == 3);
  CHECK(files[0]["valid"] == false);
  REQUIRE(files[0]["errors"].size() == 2);
  CHECK(files[0]["errors"][0]["line"] == 18);
  CHECK(files[0]["errors"][1]["column"] == 7);
  CHECK(files[1]["valid"] == false);
  CHECK(files[2]["valid"] == true);
}

TEST_CASE("the option --lenient accepts files that are otherwise refused, with a warning") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene("wibble 1 2 3\n"));
  CHECK(runCandela({"check", scene, "-q"}).exitCode == 2);
  const ProgramResult lenient = runCandela({"check", scene, "--lenient"});
  CHECK(lenient.exitCode == 0);
  CHECK(contains(lenient.out, "wibble"));
}

TEST_CASE("a report that cannot be written is an error") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const Surroundings fullDisk{{}, "/dev/full", {}};
  CHECK(runCandela({"check", scene}, fullDisk).exitCode == 2);
  CHECK(runCandela({"--help"}, fullDisk).exitCode == 2);
}

TEST_CASE("the program without a Vulkan driver exits with 4 and names the packages to install") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  for (const auto& words :
       {std::vector<std::string>{"devices"}, {scene, "-o", folder.path("a.png")}, {"compare", scene}}) {
    const ProgramResult result = runCandela(words, kNoDriver);
    INFO(words.front() << ": " << result.err);
    CHECK(result.exitCode == 4);
    CHECK(contains(result.err, "mesa-vulkan-drivers"));
  }
  CHECK(folder.fileCount() == 1);
}

TEST_CASE("the reference tracer needs no Vulkan driver") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  CHECK(runCandela({scene, "-o", folder.path("a.png"), "--spp", "1", "--device", "cpu"}, kNoDriver).exitCode == 0);
}

}  // namespace candela
