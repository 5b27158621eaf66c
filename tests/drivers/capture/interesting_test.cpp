// interesting.sh and reduce.sh, and reductions of a planted fault.
#include <catch2/catch.hpp>
#include <sstream>

#include "tests/drivers/capture/reproducer.h"

namespace candela {
namespace {

// Variables of the script. The layer changes the second execution.
std::vector<std::string> secondWith(const std::string& change) {
  std::string variables = "ENV_B=";
  for (const std::string& one : miscompiled(change)) variables += one + " ";
  return {variables};
}

std::size_t instructionsIn(const std::string& folder, const std::string& module) {
  std::istringstream lines(runIn(folder, {}, "spirv-dis --no-header " + module).out);
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line);) count += contains(line, "OpName") ? 0u : 1u;
  return count;
}

// Writes a variable that was never assigned, and a quotient whose divisor is this variable.
constexpr const char* kUndefinedModule = R"(
    OpCapability Shader
    OpMemoryModel Logical GLSL450
    OpEntryPoint GLCompute %main "main" %variable %buffer
    OpExecutionMode %main LocalSize 1 1 1
    OpName %value "value"
    OpDecorate %words ArrayStride 4
    OpDecorate %block Block
    OpMemberDecorate %block 0 Offset 0
    OpDecorate %buffer DescriptorSet 0
    OpDecorate %buffer Binding 1
    %void = OpTypeVoid
    %kind = OpTypeFunction %void
    %uint = OpTypeInt 32 0
    %uint_0 = OpConstant %uint 0
    %uint_1 = OpConstant %uint 1
    %uint_7 = OpConstant %uint 7
    %words = OpTypeRuntimeArray %uint
    %block = OpTypeStruct %words
    %block_pointer = OpTypePointer StorageBuffer %block
    %word_pointer = OpTypePointer StorageBuffer %uint
    %variable_pointer = OpTypePointer Private %uint
    %variable = OpVariable %variable_pointer Private
    %buffer = OpVariable %block_pointer StorageBuffer
    %main = OpFunction %void None %kind
    %start = OpLabel
    %value = OpLoad %uint %variable
    %first = OpAccessChain %word_pointer %buffer %uint_0 %uint_0
    OpStore %first %value
    %quotient = OpUDiv %uint %uint_7 %value
    %second = OpAccessChain %word_pointer %buffer %uint_0 %uint_1
    OpStore %second %quotient
    OpReturn
    OpFunctionEnd
)";

}  // namespace

TEST_CASE("interesting.sh accepts a module in which two executions disagree, and no other") {
  const TemporaryFolder folder;
  const std::string output = folder.path("new");
  captureTo(output, {"leaf.integer.add_carry"});
  compileReproducer(output);
  const std::string script = "./interesting.sh module_0.spv";
  CHECK(runIn(output, secondWith(kBorrowsInsteadOfCarrying), script).exitCode == 0);
  CHECK(runIn(output, {}, script).exitCode == 1);
  CHECK(runIn(output, secondWith("131:all:129"), script).exitCode == 1);  // it has no OpFSub
  CHECK(runIn(output, secondWith(kBorrowsInsteadOfCarrying), "MIN=100000 " + script).exitCode == 1);
  CHECK(runIn(output, secondWith(kBorrowsInsteadOfCarrying),
              "head -c 400 module_0.spv > cut.spv; ./interesting.sh cut.spv")
            .exitCode == 1);
}

TEST_CASE("interesting.sh accepts a module that a command makes different") {
  const TemporaryFolder folder;
  const std::string output = folder.path("new");
  captureTo(output, {"leaf.integer.add_carry"});
  compileReproducer(output);
  const std::string mutate =
      "printf '#!/bin/sh\\nspirv-dis --raw-id \"$1\" | sed s/OpIAddCarry/OpISubBorrow/ | spirv-as --target-env "
      "vulkan1.2 - -o "
      "\"$2\"\\n' > mutate.sh; chmod +x mutate.sh; ";
  CHECK(runIn(output, {"MUTATE=./mutate.sh"}, mutate + "./interesting.sh module_0.spv").exitCode == 0);
  CHECK(runIn(output, {"MUTATE=cp"}, "./interesting.sh module_0.spv").exitCode == 1);
}

TEST_CASE("interesting.sh ignores what only undefined values and operations cause") {
  const TemporaryFolder folder;
  const std::string output = folder.path("new");
  captureTo(output, {"leaf.integer.add_carry"});
  compileReproducer(output);
  folder.write("new/module.txt", kUndefinedModule);
  // Another driver has other values in variables without an initial value, or other results of divisions by 0.
  const std::string change = GENERATE("s/ Private$/ Private %uint_7/",
                                      "s/OpUDiv %uint %uint_7 %value$/OpCopyObject %uint %uint_7/");
  folder.write("new/mutate.sh",
               "#!/bin/sh\nspirv-dis $1 | sed '" + change + "' | spirv-as --target-env vulkan1.2 - -o $2\n");
  const std::vector<std::string> mutated{"MUTATE=sh mutate.sh"};
  REQUIRE(runIn(output, {}, "spirv-as --target-env vulkan1.2 module.txt -o undefined.spv").exitCode == 0);
  CHECK(runIn(output, mutated, "AS_IS=1 ./interesting.sh undefined.spv").exitCode == 0);
  CHECK(runIn(output, mutated, "./interesting.sh undefined.spv").exitCode == 1);
}

TEST_CASE("reduce.sh reduces a leaf case with a planted fault to less than half of its instructions") {
  const TemporaryFolder folder;
  const std::string output = folder.path("new");
  captureTo(output, {"leaf.integer.add_carry"}, miscompiled(kBorrowsInsteadOfCarrying));
  compileReproducer(output);
  const std::vector<std::string> faulty = secondWith(kBorrowsInsteadOfCarrying);
  const ProgramResult result = runIn(output, faulty, "./reduce.sh module_0.spv reduced.spv");
  INFO(result.out << result.err);
  CHECK(result.exitCode == 0);
  CHECK(instructionsIn(output, "reduced.spv") < instructionsIn(output, "module_0.spv") / 2);
  CHECK(contains(runIn(output, {}, "spirv-dis reduced.spv").out, "OpIAddCarry"));
  CHECK(runIn(output, faulty, "./interesting.sh reduced.spv").exitCode == 0);
}

TEST_CASE("reduce.sh refuses a module in which two executions agree") {
  const TemporaryFolder folder;
  const std::string output = folder.path("new");
  captureTo(output, {"leaf.integer.add_carry"});
  compileReproducer(output);
  const ProgramResult result = runIn(output, {}, "./reduce.sh module_0.spv reduced.spv");
  CHECK(result.exitCode == 2);
  CHECK_THAT(result.err, Catch::Contains("module_0.spv: "));
  CHECK(runIn(output, {}, "test -e reduced.spv").exitCode == 1);
}

TEST_CASE("spirv-reduce reduces a leaf case with a planted fault to less than 100 instructions", "[slow]") {
  const TemporaryFolder folder;
  const std::string output = folder.path("new");
  captureTo(output, {"leaf.integer.add_carry"}, miscompiled(kBorrowsInsteadOfCarrying));
  compileReproducer(output);
  const ProgramResult result = runIn(output, secondWith(kBorrowsInsteadOfCarrying),
                                     "spirv-reduce module_0.spv -o reduced.spv -- ./interesting.sh");
  INFO(result.err);
  CHECK(result.exitCode == 0);
  CHECK(instructionsIn(output, "reduced.spv") < 100);
  CHECK(runIn(output, secondWith(kBorrowsInsteadOfCarrying), "./interesting.sh reduced.spv").exitCode == 0);
}

}  // namespace candela
