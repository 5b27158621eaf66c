// No kernel reads values of other invocations of its subgroup: docs/architecture.md, "Common to all kernels".
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>

#include "spirv/cast_rays.h"
#include "spirv/film_means.h"
#include "spirv/make_rays.h"
#include "spirv/replay.h"
#include "spirv/wave_gather.h"
#include "spirv/wave_shadow.h"
#include "tests/drivers/variants/modules.h"

namespace candela::variants {
namespace {

// SPIR-V specification, section 3.31: GroupNonUniform to GroupNonUniformQuad, Groups, and the capabilities of
// SPV_KHR_shader_ballot, SPV_KHR_subgroup_vote and SPV_KHR_subgroup_rotate.
constexpr std::array<std::uint32_t, 12> kSubgroupCapabilities{18, 61, 62, 63, 64, 65, 66, 67, 68, 4423, 4431, 6026};
constexpr std::uint32_t kOpCapability = 17;
constexpr std::size_t kHeaderWords = 5;

bool usesSubgroups(std::span<const std::uint32_t> spirv) {
  for (std::size_t at = kHeaderWords; at < spirv.size(); at += spirv[at] >> 16) {
    if ((spirv[at] & 0xffff) != kOpCapability) return false;  // capabilities come first
    if (std::ranges::count(kSubgroupCapabilities, spirv[at + 1]) > 0) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("no kernel reads values of other invocations of its subgroup") {
  std::vector<NamedModule> modules = testModules();
  modules.insert(modules.end(), {{"cast_rays", spirv::cast_rays},
                                 {"film_means", spirv::film_means},
                                 {"make_rays", spirv::make_rays},
                                 {"replay", spirv::replay},
                                 {"wave_gather", spirv::wave_gather},
                                 {"wave_renew", spirv::wave_renew},
                                 {"wave_shadow", spirv::wave_shadow}});
  for (const NamedModule& module : modules) {
    INFO(module.name);
    CHECK_FALSE(usesSubgroups(module.spirv));
  }
  std::vector<std::uint32_t> votes(spirv::path.begin(), spirv::path.end());
  votes.insert(votes.begin() + kHeaderWords, {2u << 16 | kOpCapability, 62});
  CHECK(usesSubgroups(votes));
}

}  // namespace candela::variants
