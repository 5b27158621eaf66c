// The decoration NoContraction, and the loop control Unroll.
#include "host/drivers/variants/no_contraction.h"

#include <catch2/catch.hpp>

#include "host/drivers/variants/passes.h"
#include "host/drivers/variants/unroll_control.h"
#include "tests/drivers/variants/modules.h"

namespace candela::variants {

TEST_CASE("variants: every floating-point operation is decorated once") {
  for (const NamedModule& named : testModules()) {
    CAPTURE(named.name);
    Module module = parseModule(named.spirv);
    const FloatOperations before = floatOperations(module);
    forbidContraction(module);
    const FloatOperations after = floatOperations(module);
    CHECK(after.all == before.all);
    CHECK(after.decorated == after.all);
    const Code once = codeOf(module);
    CHECK(validationOf(once) == "");
    CHECK(once.size() == named.spirv.size() + 3 * (before.all - before.decorated));
    forbidContraction(module);
    CHECK(codeOf(module) == once);
  }
}

TEST_CASE("variants: the shipped path kernel decorates some of its floating-point operations") {
  const FloatOperations found = floatOperations(parseModule(spirv::path));
  CHECK(found.decorated > 100);
  CHECK(found.all > 4 * found.decorated);
}

TEST_CASE("variants: the unroller of spirv-opt unrolls loops only after their control is set") {
  const std::vector<std::string> passes{"ssa-rewrite", "ccp", "loop-unroll"};
  const auto loopsOf = [](const Code& code) {
    Module module = parseModule(code);
    return requestUnrolling(module);
  };
  Module module = parseModule(spirv::control);
  const std::size_t loops = requestUnrolling(module);
  CHECK(loopsOf(optimised(spirv::control, passes)) == loops);
  CHECK(loopsOf(optimised(codeOf(module), passes)) != loops);
}

}  // namespace candela::variants
