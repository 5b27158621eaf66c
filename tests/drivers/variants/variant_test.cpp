// The table of variants.
#include "host/drivers/variants/variant.h"

#include <catch2/catch.hpp>
#include <set>

#include "host/drivers/variants/no_contraction.h"
#include "shaders/shared/specialization.h"
#include "tests/drivers/variants/modules.h"

namespace candela::variants {
namespace {

const std::vector<vulkan::Specialisation> kWorkgroup{{gpu::kSpecWorkgroupX, 4}, {gpu::kSpecWorkgroupY, 2}};

FloatOperations operationsOf(const vulkan::ShaderCode& made) { return floatOperations(parseModule(made.words)); }

}  // namespace

TEST_CASE("variants: each one changes a module, which stays valid") {
  for (const std::span<const std::uint32_t> spirv : {spirv::wave_renew, spirv::control}) {
    const Code plain = preparation(plainVariant())(spirv, kWorkgroup).words;
    CHECK(validationOf(plain) == "");
    std::set<Code> different{plain};
    for (const Variant& variant : allVariants()) {
      CAPTURE(variant.name);
      const Code made = preparation(variant)(spirv, kWorkgroup).words;
      CHECK(validationOf(made) == "");
      CHECK(different.insert(made).second);
    }
  }
}

TEST_CASE("variants: only an open variant leaves constants to the driver") {
  for (const Variant& variant : allVariants()) {
    const vulkan::ShaderCode made = preparation(variant)(spirv::wave_renew, kWorkgroup);
    CHECK(made.specialisations.empty() == (variant.constants != Constants::open));
  }
}

TEST_CASE("variants: modules that must agree bit for bit have NoContraction everywhere, and others are as shipped") {
  const FloatOperations decorated = operationsOf(preparation(plainVariant())(spirv::wave_renew, kWorkgroup));
  CHECK(decorated.decorated == decorated.all);
  const vulkan::ShaderCode shipped = preparation(withContraction(plainVariant()))(spirv::wave_renew, kWorkgroup);
  CHECK(shipped.words == vulkan::reducedSpirv(spirv::wave_renew, kWorkgroup));
}

TEST_CASE("variants: modules that are not selected get the plain form, and steps report their changes") {
  std::vector<std::string> notes;
  PreparationScope scope;
  scope.isMeant = [](std::span<const std::uint32_t> spirv) { return spirv.data() == spirv::control.data(); };
  scope.note = [&](std::span<const std::uint32_t>, const std::string& text) { notes.push_back(text); };
  const Variant variant{"some", {{StepKind::requestUnrolling}, {StepKind::mutation, {}, {5, 1}}}};
  const auto prepare = preparation(variant, scope);
  CHECK(prepare(spirv::memory, {}).words == preparation(plainVariant())(spirv::memory, {}).words);
  CHECK(notes.empty());
  prepare(spirv::control, {});
  REQUIRE(notes.size() == 2);
  CHECK_THAT(notes[0], Catch::Contains("loop control Unroll of "));
  CHECK_THAT(notes[1], Catch::StartsWith("mutation 1 of seed 5: ") && Catch::Contains(" at %"));
}

}  // namespace candela::variants
