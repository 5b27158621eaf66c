// Captures of variants, whose plain form computes the expected values.
#include <catch2/catch.hpp>
#include <filesystem>

#include "tests/drivers/capture/reproducer.h"

namespace candela {
namespace {

using Catch::Contains;

// Faults that affect only variants: OpCopyObject becomes OpSNegate, or the last index of OpCompositeInsert is off by
// one.
constexpr const char* kFaultyCopies = "83:all:126";
constexpr const char* kFaultyInserts = "82:all:plus";

// The modules of a fault need not be valid.
std::vector<std::string> faultyEnvironment(const char* change) {
  std::vector<std::string> environment = miscompiled(change);
  environment.emplace_back("CANDELA_VALIDATION=0");
  return environment;
}

}  // namespace

TEST_CASE("capture: a variant differs in the program, and the plain form beside it does not") {
  const TemporaryFolder folder;
  const std::string output = folder.path("new");
  const std::vector<std::string> faulty = faultyEnvironment(kFaultyCopies);
  CHECK_THAT(captureTo(output, {"variants.module.mutated_4.control.loop.return"}, faulty).out,
             Contains("computes other values") && Contains("plain_0.spv"));
  compileReproducer(output);
  CHECK(runIn(output, faulty).exitCode == 1);
  CHECK(runIn(output, faulty, "./reproduce --module 0 plain_0.spv").exitCode == 0);
  CHECK(runIn(output).exitCode == 0);
  CHECK_THAT(readText(output + "/README.md"), Contains("`./reproduce --module 0 plain_0.spv`"));
}

TEST_CASE("capture: a variant of a kernel expects the bits of the plain form, and one pixel suffices",
          "[swiftshader-slow]") {
  const TemporaryFolder folder;
  const std::string output = folder.path("new");
  const std::vector<std::string> faulty = faultyEnvironment(kFaultyInserts);
  const ProgramResult result = captureTo(output, {"variants.path.Os.cornell"}, faulty);
  CHECK_THAT(result.out, Contains("It renders 1 x 1 pixels") && Contains("computes other values"));
  compileReproducer(output);
  CHECK(runIn(output, faulty).exitCode == 1);
  CHECK(runIn(output, faulty, "./reproduce --module 0 plain_0.spv").exitCode == 0);
  CHECK(runIn(output).exitCode == 0);
}

TEST_CASE("capture: a form whose constants the driver sets is captured with its constants set") {
  const TemporaryFolder folder;
  const std::string output = folder.path("new");
  CHECK_THAT(captureTo(output, {"variants.module.open.leaf.float.sqrt"}).out, Contains("computes the expected values"));
  compileReproducer(output);
  CHECK(runIn(output).exitCode == 0);
  CHECK(std::filesystem::file_size(output + "/plain_0.spv") > 0);
  CHECK(std::filesystem::file_size(output + "/module_0.spv") > std::filesystem::file_size(output + "/plain_0.spv"));
}

}  // namespace candela
