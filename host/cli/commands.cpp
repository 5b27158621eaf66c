// The table of commands.
#include "host/cli/commands.h"

#include <array>
#include <limits>

namespace candela::cli {

std::span<const CommandInfo> commandTable() {
  constexpr std::size_t kAnyNumber = std::numeric_limits<std::size_t>::max();
  static const std::array<CommandInfo, 10> table{{
      {Command::render, "render", "[render] SCENE -o FILE", "traces a P3F or NFF scene", "scene", 1, 1, runRender},
      {Command::devices, "devices", "devices", "lists the Vulkan devices", "", 0, 0, runDevices},
      {Command::check, "check", "check FILE...", "says what scenes contain, or all that is wrong with them", "scene", 1,
       kAnyNumber, runCheck},
      {Command::compare, "compare", "compare A B | SCENE",
       "compares two images, or a device's image of a scene with the reference's", "image or scene", 1, 2, runCompare},
      {Command::verify, "verify", "verify SCENE",
       "decides whether a device computes the reference's light, with a known rate of false alarms", "scene", 1, 1,
       runVerify},
      {Command::explain, "explain", "explain SCENE",
       "traces one sample on a device and on the reference, and shows where the two paths part", "scene", 1, 1,
       runExplain},
      {Command::generate, "generate", "generate KIND", "writes a procedural scene; its help lists the kinds", "kind", 1,
       1, runGenerate},
      {Command::boxes, "boxes", "boxes SCENE", "writes the boxes of a scene's BVH as a scene", "scene", 1, 1, runBoxes},
      {Command::bench, "bench", "bench SCENE... | table1 | accel SCENE... | rays SCENE... | compare OLD.json NEW.json",
       "times renders of scenes, search structures (on those of the report's Table 1 or on others) or rays alone, or "
       "compares two such reports",
       "benchmark", 1, kAnyNumber, runBench},
      {Command::tune, "tune", "tune [SCENE...]",
       "measures what is fastest on a device and keeps it: from then on `auto` means that", "scene", 0, kAnyNumber,
       runTune},
  }};
  return table;
}

const CommandInfo& commandInfo(Command command) {
  for (const CommandInfo& info : commandTable()) {
    if (info.command == command) return info;
  }
  throw InternalError("a command without an entry in the table");
}

}  // namespace candela::cli
