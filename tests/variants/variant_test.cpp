// The table of variants.
#include "host/variants/variant.h"

#include <catch2/catch.hpp>

#include "tests/variants/modules.h"

namespace candela::variants {

TEST_CASE("variants: every variant changes a kernel, which stays valid") {
  const NamedModule named = testModules().front();
  const Code plain = preparation(plainVariant())(named.spirv, {}).words;
  CHECK(validationOf(plain) == "");
  for (const Variant& variant : allVariants()) {
    CAPTURE(variant.name);
    const vulkan::ShaderCode made = preparation(variant)(named.spirv, {});
    WARN(variant.name << " " << made.words.size() << " of " << plain.size());
    CHECK(made.words != plain);
    CHECK(validationOf(made.words) == "");
  }
}

}  // namespace candela::variants
