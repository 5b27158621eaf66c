// NoContraction.
#include "host/variants/no_contraction.h"

#include <catch2/catch.hpp>

#include "host/variants/unroll_control.h"
#include "tests/variants/modules.h"

namespace candela::variants {

TEST_CASE("variants: every floating-point operation is decorated once") {
  for (const NamedModule& named : testModules()) {
    CAPTURE(named.name);
    Module module = parseModule(named.spirv);
    const FloatOperations before = floatOperations(module);
    forbidContraction(module);
    const FloatOperations after = floatOperations(module);
    WARN(named.name << ": " << before.decorated << " of " << before.all);
    CHECK(after.all == before.all);
    CHECK(after.decorated == after.all);
    CHECK(validationOf(codeOf(module)) == "");
    const Code once = codeOf(module);
    forbidContraction(module);
    CHECK(codeOf(module) == once);
  }
}

}  // namespace candela::variants
