// Variants on a driver: without faults, with its known fault, and with planted ones.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/app/cli/run_program.h"
#include "tests/drivers/capture/miscompiled.h"
#include "tests/trace/vulkan_support/test_device.h"

namespace candela {
namespace {

using Catch::Contains;
using nlohmann::json;

// Opcodes of a fault: OpCopyObject, which only mutations contain, becomes OpSNegate; the last index of
// OpCompositeInsert, which only optimised modules contain, is off by one.
constexpr const char* kCopiesWithAMinus = "83:all:126";
constexpr const char* kInsertsBesideIt = "82:all:plus";

struct Result {
  int exitCode = 0;
  json cases;
};

// Modules of a planted fault need not be valid.
std::vector<std::string> faulty(const std::string& change) {
  std::vector<std::string> environment = miscompiled(change);
  environment.emplace_back("CANDELA_VALIDATION=0");
  return environment;
}

Result runVariants(const std::string& glob, const std::vector<std::string>& environment = {}) {
  const ProgramResult result = runCandela({"conformance", "--variants", "--cases", glob, "--json", "-", "--jobs", "2",
                                           "--timeout", "240s", "--shrink-time", "240s"},
                                          {.environment = environment});
  INFO(result.err);
  REQUIRE((result.exitCode == 0 || result.exitCode == 3));
  return {result.exitCode, json::parse(result.out)["cases"]};
}

std::string textOf(const Result& result) { return result.cases.at(0)["text"]; }

bool isOnMesa22() { return openTestDevice().info().driver.find("Mesa 22.3.6") != std::string::npos; }

}  // namespace

TEST_CASE("variants: small modules give equal results in every variant") {
  for (const char* const glob : {"variants.module.*.control.loop.nested_break", "variants.module.*.leaf.film.sums",
                                 "variants.module.*.memory.shared.scan", "variants.module.*.leaf.float.add"}) {
    const Result result = runVariants(glob);
    INFO(result.cases.dump());
    CHECK(result.exitCode == 0);
    CHECK(result.cases.size() == 11);
  }
}

TEST_CASE("variants: a kernel renders equal bits in optimised and mutated forms") {
  const Result result = runVariants("variants.path.[Om]*[s1].cornell");
  INFO(result.cases.dump());
  CHECK(result.exitCode == 0);
  CHECK(result.cases.size() == 2);
}

TEST_CASE("variants: a fault that affects one mutation is found and shrunk to it") {
  const Result result = runVariants("variants.module.mutated_4.control.loop.return", faulty(kCopiesWithAMinus));
  INFO(result.cases.dump());
  CHECK(result.exitCode == 3);
  CHECK_THAT(textOf(result), Contains("plain and mutated_4 differ: Pass and Fail"));
  CHECK_THAT(textOf(result), Contains(": 1 of 64 steps, in 1 of 1 modules: control\ncontrol: mutation "));
  CHECK_THAT(textOf(result), Contains(" of seed 4: copy at %"));
}

TEST_CASE("variants: a fault that affects optimised modules is shrunk to the pass that makes its instruction",
          "[swiftshader-slow]") {
  const Result result = runVariants("variants.path.O.cornell", faulty(kInsertsBesideIt));
  INFO(result.cases.dump());
  CHECK(result.exitCode == 3);
  CHECK_THAT(textOf(result), Contains("the films of plain and O differ in "));
  CHECK_THAT(textOf(result),
             Contains(": 1 of 44 steps, in 1 of 1 modules: path\nspirv-opt --convert-local-access-chains"));
}

TEST_CASE("variants: a fault in one stage of the wavefront names its module", "[slow]") {
  const Result result = runVariants("variants.wavefront.mutated_2.cornell", faulty(kCopiesWithAMinus));
  INFO(result.cases.dump());
  CHECK(result.exitCode == 3);
  CHECK_THAT(textOf(result), Contains(": 1 of 64 steps, in 1 of 5 modules: wave_"));
}

TEST_CASE("variants: the loop in which lavapipe 22.3.6 counts a value twice is right in another variant") {
  const Result result = runVariants("variants.module.mutated_1_O.control.loop.ended_in_the_middle");
  INFO(result.cases.dump());
  CHECK(result.exitCode == (isOnMesa22() ? 3 : 0));
  if (!isOnMesa22()) return;
  CHECK_THAT(textOf(result), Contains("plain and mutated_1_O differ: Fail, 2592 of 4000 values differ"));
  CHECK_THAT(textOf(result), Contains(": 3 of 108 steps") && Contains("spirv-opt --if-conversion"));
}

TEST_CASE("variants: all results are those of the driver's baseline", "[slow]") {
  const bool isMesa22 = isOnMesa22();
  const Result result = runVariants("variants.module.*");
  for (const json& one : result.cases) {
    CAPTURE(one.dump());
    const bool isKnown = isMesa22 && one["name"] == "variants.module.mutated_1_O.control.loop.ended_in_the_middle";
    CHECK((one["result"] == "Fail") == isKnown);
  }
}

}  // namespace candela
