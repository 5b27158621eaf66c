// Options of `candela capture`.
#include "host/app/cli/option_groups.h"
#include "host/app/cli/option_kinds.h"

namespace candela::cli {

// NOLINTBEGIN: each option is one row of any length.
// clang-format off
std::vector<Option> captureOptions() {
  constexpr OptionGroup kGroup = OptionGroup::capture;
  return {
    path<CaptureArguments>({"-o,--output", kGroup, "new folder with the program and its data"}, "FOLDER",
         [](auto& a) -> auto& { return a.folder; }),
    valued<CaptureArguments>({"--pixel", kGroup, "for a scene: pixel whose sample is captured; 0,0 is the top left"},
           orAbsent(pixelPosition(image::kMaxImageSide - 1), ""), [](auto& a) -> auto& { return a.pixel; }),
    valued<CaptureArguments>({"--expect", kGroup, "expect exactly the values that another device computes, named as for --device (default: the values that the host computes, with a tolerance for each)"},
           text("DEVICE", "a device"), [](auto& a) -> auto& { return a.expect; }),
    valued<ShrinkArguments>({"--shrink-time", kGroup, "if the device is wrong: time for removing the parts of the scene, or the transformations of a variant, that the failure does not need; 0s: none"},
           duration(0), [](auto& a) -> auto& { return a.shrinkSeconds; }),
  };
}
// clang-format on
// NOLINTEND

}  // namespace candela::cli
