// Captures of cases, which are compiled and run.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "tests/drivers/capture/reproducer.h"
#include "tests/trace/vulkan_support/test_device.h"

namespace candela {
namespace {

using Catch::Contains;

bool isLavapipe22() { return openTestDevice().info().driver.find("Mesa 22.3.6") != std::string::npos; }

}  // namespace

TEST_CASE("capture: a program gives the results of each kind of case", "[swiftshader-slow]") {
  const TemporaryFolder folder;
  for (const char* const name :
       {"leaf.integer.shift", "leaf.float.sqrt", "leaf.function.cap", "leaf.film.carry", "leaf.sampler.sobol",
        "control.loop.nested_break", "control.stack.deep", "memory.atomic.positions", "memory.shared.scan",
        "memory.storage.records", "memory.dispatch.chain", "memory.dispatch.queue", "memory.robust.read_texels",
        "group.size.8x8x1"}) {
    CAPTURE(name);
    const std::string output = folder.path(name);
    const ProgramResult result = captureTo(output, {name});
    CHECK_THAT(result.out, Contains("computes the expected values"));
    compileReproducer(output);
    const ProgramResult run = runIn(output, {"VK_INSTANCE_LAYERS=VK_LAYER_KHRONOS_validation"});
    INFO(run.out << run.err);
    CHECK(run.exitCode == 0);
    CHECK_THAT(run.out + run.err, !Contains("VUID"));
    CHECK_THAT(run.out, Contains(name));
    CHECK_THAT(run.out, Contains("\n0 of "));
  }
}

TEST_CASE("capture: a program chooses the device of the capture, and warns where it is missing") {
  const TemporaryFolder folder;
  const std::string output = folder.path("shift");
  captureTo(output, {"leaf.integer.shift"});
  compileReproducer(output);
  CHECK_THAT(runIn(output).out, Contains("leaf.integer.shift on " + openTestDevice().info().name));
  const std::string header = readText(output + "/capture.h");
  const std::string line = "#define CAPTURE_DEVICE \"";
  REQUIRE_THAT(header, Contains(line + openTestDevice().info().name));
  const std::string other = header.substr(0, header.find(line)) + line + "Other " +
                            header.substr(header.find(line) + line.size());
  std::ofstream(output + "/capture.h") << other;
  compileReproducer(output);
  CHECK_THAT(runIn(output).out, Contains("warning: the capture is of Other ") && Contains("using device 0"));
}

TEST_CASE("capture: the known faults of lavapipe 22.3.6 are reduced to one or two invocations") {
  const TemporaryFolder folder;
  const bool isWrong = isLavapipe22();
  struct Known {
    const char* name;
    const char* mismatch;
    const char* header;
    const char* readme;
  };
  for (const Known& known :
       {Known{"control.loop.iterations", "buffer 1, word 0: expected 1048576 (0x100000), found 65535 (0xffff)",
              ".push = {0x1u, 0x100000u}, .groups = {1, 1, 1}", "2 of 4 values differ"},
        Known{"control.loop.ended_in_the_middle", "buffer 1, word 0: expected 1627 (0x65b), found 1831 (0x727)",
              ".push = {0x2u, 0x0u}, .groups = {1, 1, 1}", "3 of 8 values differ"}}) {
    const std::string output = folder.path(known.name);
    captureTo(output, {known.name});
    compileReproducer(output);
    const ProgramResult run = runIn(output);
    CHECK(run.exitCode == (isWrong ? 1 : 0));
    if (!isWrong) continue;
    CHECK_THAT(run.out, Contains(known.mismatch));
    CHECK_THAT(readText(output + "/capture.h"), Contains(known.header));
    CHECK_THAT(readText(output + "/README.md"), Contains(known.readme) && Contains("They were reduced from "));
  }
}

TEST_CASE("capture: a planted fault of a compiler shows in the program where the compiler has it, and only there") {
  const TemporaryFolder folder;
  const std::string output = folder.path("new");
  const std::vector<std::string> faulty = miscompiled(kBorrowsInsteadOfCarrying);
  CHECK_THAT(captureTo(output, {"leaf.integer.add_carry"}, faulty).out, Contains("computes other values"));
  compileReproducer(output);
  CHECK(runIn(output, faulty).exitCode == 1);
  CHECK(runIn(output).exitCode == 0);
  CHECK_THAT(readText(output + "/capture.h"), Contains(".push = {0x1u"));
}

TEST_CASE("capture: work that the program cannot run is not a mismatch") {
  const TemporaryFolder folder;
  const std::string output = folder.path("new");
  captureTo(output, {"leaf.integer.shift"});
  compileReproducer(output);
  CHECK(runIn(output, {}, "VK_DRIVER_FILES=/no.json VK_ICD_FILENAMES=/no.json ./reproduce").exitCode == 2);
  CHECK(runIn(output, {}, "./reproduce --device 9").exitCode == 2);
  CHECK(runIn(output, {}, "./reproduce --module 0 nothing.spv").exitCode == 2);
  CHECK(runIn(output, {}, "./reproduce --nonsense").exitCode == 2);
  CHECK(runIn(folder.path(""), {}, "new/reproduce").exitCode == 2);
}

TEST_CASE("capture: the values that one run dumps are the expected values of another") {
  const TemporaryFolder folder;
  const std::string output = folder.path("new");
  captureTo(output, {"leaf.float.add"});
  compileReproducer(output);
  REQUIRE(runIn(output, {}, "./reproduce --dump values").exitCode == 0);
  CHECK(std::filesystem::file_size(output + "/values") == 4096 * 4);
  CHECK(runIn(output, {}, "./reproduce --against values 0").exitCode == 0);
  const std::vector<std::string> faulty = miscompiled("129:all:131");  // OpFAdd, OpFSub
  CHECK(runIn(output, faulty, "./reproduce --against values 0").exitCode == 1);
  CHECK(runIn(output, faulty, "./reproduce --against values 1e9").exitCode == 0);
  CHECK(runIn(output, {}, "head -c 100 values > cut && ./reproduce --against cut 0").exitCode == 2);
}

TEST_CASE("conformance --capture writes a folder for each case that fails") {
  const TemporaryFolder folder;
  const std::vector<std::string> words{"conformance", "--cases", "leaf.integer.*", "--capture", folder.path("new")};
  CHECK(runCandela(words).exitCode == 0);
  CHECK_FALSE(std::filesystem::exists(folder.path("new")));
  const std::vector<std::string> faulty = miscompiled(kBorrowsInsteadOfCarrying);
  const ProgramResult result = runCandela(words, {.environment = faulty});
  CHECK(result.exitCode == 3);
  CHECK_THAT(result.err, Contains("leaf.integer.add_carry: captured in"));
  const std::string output = folder.path("new/leaf.integer.add_carry");
  compileReproducer(output);
  CHECK(runIn(output, faulty).exitCode == 1);
}

TEST_CASE("capture: a feature that the device lacks is named") {
  const TemporaryFolder folder;
  for (const char* const name : {"group.subgroup.64", "kernel.megakernel.subgroup.64.cornell"}) {
    const ProgramResult result = runCandela({"capture", name, "-o", folder.path("new")});
    CAPTURE(name);
    CHECK(result.exitCode == 1);
    CHECK_THAT(result.err, Contains(", which lacks subgroups of 64 invocations in compute shaders (minimum "));
    CHECK_FALSE(std::filesystem::exists(folder.path("new")));
  }
}

TEST_CASE("conformance --capture ends soon after SIGTERM, and leaves no part of a capture", "[swiftshader-slow]") {
  const TemporaryFolder folder;
  std::vector<std::string> faulty = miscompiled("133:0:129");  // one OpFMul becomes OpFAdd
  faulty.emplace_back("CANDELA_VALIDATION=0");
  const std::string script =
      "\"$0\" conformance --cases kernel.megakernel.scene.primitives --csv done.csv --capture new & "
      "while ! [ -s done.csv ] && kill -0 $!; do sleep 0.1; done; sleep 1; kill -TERM $!; wait $!";
  const ProgramResult result = runProgram(
      "/bin/sh", {"-c", "cd \"$1\" || exit; " + script, CANDELA_PROGRAM, folder.path("")}, {.environment = faulty});
  INFO(result.out << result.err);
  CHECK(result.exitCode == 7);
  CHECK_THAT(result.err, Contains("interrupted after 1 of 1 case") && !Contains("the process that captures it"));
  CHECK_FALSE(std::filesystem::exists(folder.path("new")));
}

}  // namespace candela
