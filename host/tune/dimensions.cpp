#include "host/tune/dimensions.h"

#include <algorithm>
#include <array>

#include "host/render/workgroup.h"

namespace candela::tune {
namespace {

template <std::uint32_t width, std::uint32_t height>
Value shape() {
  return {extentText({width, height}), [](AutomaticChoices& choices) { choices.workgroup = {width, height}; }};
}

}  // namespace

std::span<const Dimension> dimensionTable() {
  // Fewer variants in a stage than PipelineStore::kCapacity: a renderer that forgets pipelines compiles all the time.
  static const std::array<Dimension, 4> table{{
      {"layout",
       0,
       {{"cwbvh", [](AutomaticChoices& choices) { choices.bvhLayout = BvhLayout::cwbvh; }},
        {"bvh2", [](AutomaticChoices& choices) { choices.bvhLayout = BvhLayout::bvh2; }}}},
      {"loads",
       0,
       {{"texel", [](AutomaticChoices& choices) { choices.sceneLoads = SceneLoads::texel; }},
        {"storage", [](AutomaticChoices& choices) { choices.sceneLoads = SceneLoads::storage; }}}},
      {"workgroup",
       1,
       {shape<8, 8>(), shape<8, 4>(), shape<16, 4>(), shape<16, 8>(), shape<16, 16>(), shape<32, 1>(), shape<64, 1>()}},
      {"kernel",
       2,
       {{"megakernel", [](AutomaticChoices& choices) { choices.kernel = KernelKind::megakernel; }},
        {"wavefront", [](AutomaticChoices& choices) { choices.kernel = KernelKind::wavefront; }}}},
  }};
  return table;
}

Candidate builtIn() { return Candidate(dimensionTable().size(), 0); }

std::string nameOf(const Candidate& candidate) {
  std::string name;
  for (std::size_t i = 0; i < candidate.size(); ++i) {
    const Dimension& dimension = dimensionTable()[i];
    if (i > 0) name += ' ';
    name += dimension.option + "=" + dimension.values[candidate[i]].name;
  }
  return name;
}

AutomaticChoices choicesOf(const Candidate& candidate) {
  AutomaticChoices choices;
  for (std::size_t i = 0; i < candidate.size(); ++i) dimensionTable()[i].values[candidate[i]].choose(choices);
  return choices;
}

bool isFeasible(const Candidate& candidate, const DeviceInfo& info) {
  return hasWorkgroup(info, choicesOf(candidate).workgroup);
}

std::optional<std::size_t> valueNamed(const Dimension& dimension, const std::string& name) {
  const auto found = std::ranges::find(dimension.values, name, &Value::name);
  if (found == dimension.values.end()) return std::nullopt;
  return static_cast<std::size_t>(found - dimension.values.begin());
}

}  // namespace candela::tune
