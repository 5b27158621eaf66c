// The table of tuned options.
#include "host/measure/tune/dimensions.h"

#include <algorithm>
#include <array>

#include "host/trace/device/workgroup.h"

namespace candela::tune {
namespace {

template <std::uint32_t width, std::uint32_t height>
Value shape() {
  return {render::extentText({width, height}), [](render::AutomaticChoices& choices) {
            choices.workgroup = {width, height};
          }};
}

}  // namespace

std::span<const Dimension> dimensionTable() {
  // The variants of a stage are fewer than PipelineStore::kCapacity: otherwise the renderer would compile pipelines
  // again and again.
  static const std::array<Dimension, 4> table{{
      {"layout",
       0,
       {{"cwbvh", [](render::AutomaticChoices& choices) { choices.bvhLayout = render::BvhLayout::cwbvh; }},
        {"bvh2", [](render::AutomaticChoices& choices) { choices.bvhLayout = render::BvhLayout::bvh2; }}}},
      {"loads",
       0,
       {{"auto", [](render::AutomaticChoices& choices) { choices.sceneLoads = render::SceneLoads::automatic; }},
        {"texel", [](render::AutomaticChoices& choices) { choices.sceneLoads = render::SceneLoads::texel; }},
        {"storage", [](render::AutomaticChoices& choices) { choices.sceneLoads = render::SceneLoads::storage; }}}},
      {"workgroup",
       1,
       {shape<8, 8>(), shape<8, 4>(), shape<16, 4>(), shape<16, 8>(), shape<16, 16>(), shape<32, 1>(), shape<64, 1>()}},
      {"kernel",
       2,
       {{"megakernel", [](render::AutomaticChoices& choices) { choices.kernel = render::KernelKind::megakernel; }},
        {"wavefront", [](render::AutomaticChoices& choices) { choices.kernel = render::KernelKind::wavefront; }}}},
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

render::AutomaticChoices choicesOf(const Candidate& candidate) {
  render::AutomaticChoices choices;
  for (std::size_t i = 0; i < candidate.size(); ++i) dimensionTable()[i].values[candidate[i]].choose(choices);
  return choices;
}

bool isFeasible(const Candidate& candidate, const vulkan::DeviceInfo& info) {
  return device::hasWorkgroup(info, choicesOf(candidate).workgroup);
}

std::optional<std::size_t> valueNamed(const Dimension& dimension, const std::string& name) {
  const auto found = std::ranges::find(dimension.values, name, &Value::name);
  if (found == dimension.values.end()) return std::nullopt;
  return static_cast<std::size_t>(found - dimension.values.begin());
}

}  // namespace candela::tune
