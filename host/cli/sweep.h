// `--sweep NAME=VALUE,VALUE,...`: the values that a benchmark gives to an option, one after the other.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "host/cli/arguments.h"

namespace candela::cli {

/// One way to set the options that are swept.
struct SweptArguments {
  std::string name;  ///< e.g. "workgroup=8x8 layout=cwbvh"; "as given" where nothing is swept
  Arguments arguments;
};

/// All combinations of the values of `arguments.sweeps`, the last sweep's changing fastest. NAME is an option of images
/// or of their execution, without its dashes. Throws UsageError for one that is none, that is swept twice, or that
/// cannot have a value; and for more than kMostVariants combinations.
std::vector<SweptArguments> sweepOver(const Arguments& arguments);

inline constexpr std::size_t kMostVariants = 256;

}  // namespace candela::cli
