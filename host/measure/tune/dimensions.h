// The tuned options, none of which changes the image, and the values that are tried for each.
#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host/trace/render/settings.h"
#include "host/trace/vulkan/device_info.h"

namespace candela::tune {

struct Value {
  std::string name;  ///< as on the command line
  void (*choose)(render::AutomaticChoices& choices);
};

/// One option. The first of its values is the built-in one.
struct Dimension {
  std::string option;  ///< without dashes
  /// Options of one stage are tried in all combinations; later stages use the results of earlier ones.
  std::size_t stage;
  std::vector<Value> values;
};

/// Returns all tuned options, by stage. To tune another option, add a row.
std::span<const Dimension> dimensionTable();

/// The index of the value of each dimension. All 0 is the built-in choice.
using Candidate = std::vector<std::size_t>;

Candidate builtIn();
/// E.g. "layout=cwbvh loads=texel workgroup=8x8 kernel=megakernel".
std::string nameOf(const Candidate& candidate);
render::AutomaticChoices choicesOf(const Candidate& candidate);
bool isFeasible(const Candidate& candidate, const vulkan::DeviceInfo& info);

/// Returns the index of a value, if the dimension has it.
std::optional<std::size_t> valueNamed(const Dimension& dimension, const std::string& name);

}  // namespace candela::tune
