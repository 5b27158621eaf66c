// `--sweep NAME=VALUE,VALUE,...`: the values of an option that a benchmark measures.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "host/app/cli/command_arguments.h"

namespace candela::cli {

/// One combination of the values of the swept options.
struct SweptArguments {
  std::string name;  ///< e.g. "workgroup=8x8 layout=cwbvh"; "as given" without a sweep
  BenchArguments arguments;
};

/// Returns all combinations of the values of `arguments.sweeps`, the last sweep varying fastest. NAME is an option of
/// images or of their execution, without its dashes. Throws UsageError for any other name, for a repeated name, for an
/// invalid value, and for more than kMaxVariants combinations.
std::vector<SweptArguments> sweepOver(const BenchArguments& arguments);

inline constexpr std::size_t kMaxVariants = 256;

}  // namespace candela::cli
