// What is tuned: the options that never change the image, and the values that are tried of each.
#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host/render/settings.h"
#include "host/vulkan/device_info.h"

namespace candela::tune {

struct Value {
  std::string name;  ///< as on the command line
  void (*choose)(render::AutomaticChoices& choices);
};

/// One option. The first of its values is the built-in one.
struct Dimension {
  std::string option;  ///< without dashes
  std::size_t stage;  ///< options of one stage are tried in all combinations, later stages with what earlier ones found
  std::vector<Value> values;
};

/// All that is tuned, by stage. Another option is another row.
std::span<const Dimension> dimensionTable();

/// One value of each dimension, by number; all 0: what is built in.
using Candidate = std::vector<std::size_t>;

Candidate builtIn();
/// E.g. "layout=cwbvh loads=texel workgroup=8x8 kernel=megakernel".
std::string nameOf(const Candidate& candidate);
render::AutomaticChoices choicesOf(const Candidate& candidate);
bool isFeasible(const Candidate& candidate, const vulkan::DeviceInfo& info);

/// The number of a value, if the dimension has it.
std::optional<std::size_t> valueNamed(const Dimension& dimension, const std::string& name);

}  // namespace candela::tune
