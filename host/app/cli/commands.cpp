// The table of commands.
#include "host/app/cli/commands.h"

#include <array>
#include <limits>

namespace candela::cli {

std::span<const CommandInfo> commandTable() {
  constexpr std::size_t kUnlimited = std::numeric_limits<std::size_t>::max();
  static const std::array<CommandInfo, 19> table{{
      {Command::render, "render", "[render] SCENE -o FILE", "render a scene: glTF, Mitsuba, OBJ, PLY, P3F or NFF",
       "scene", 1, 1},
      {Command::view, "view", "view SCENE",
       "show a scene in a window while a device, the reference tracer or both render it", "scene", 1, 1},
      {Command::devices, "devices", "devices", "list the Vulkan devices", "", 0, 0},
      {Command::doctor, "doctor", "doctor",
       "check whether this machine can render, and report what is wrong and how to fix it", "", 0, 0},
      {Command::check, "check", "check FILE...", "describe scenes, or list all of their errors", "scene", 1,
       kUnlimited},
      {Command::compare, "compare", "compare A B | A... --with B... | SCENE",
       "compare two images, two sets of renders by any renderers, or a device's image of a scene with that of the "
       "reference tracer",
       "image or scene", 1, kUnlimited},
      {Command::verify, "verify", "verify SCENE",
       "test statistically whether a device computes the same light as the reference tracer", "scene", 1, 1},
      {Command::conformance, "conformance", "conformance",
       "run many small cases on a device, each in a child process, and compare the results with those of a baseline",
       "", 0, 0},
      {Command::explain, "explain", "explain SCENE",
       "trace one sample on a device and on the reference tracer, and show where the paths diverge", "scene", 1, 1},
      {Command::capture, "capture", "capture SCENE | CASE -o FOLDER",
       "write a C program that repeats one sample of a scene, or one case of `candela conformance`, with its shaders, "
       "data and expected results",
       "scene or case", 1, 1},
      {Command::generate, "generate", "generate KIND",
       "write a procedural scene; `candela generate --help` lists the kinds", "kind", 1, 1},
      {Command::boxes, "boxes", "boxes SCENE", "write the boxes of a scene's BVH as a scene", "scene", 1, 1},
      {Command::film, "film", "film FILE", "describe a film file, or make pictures of it without rendering",
       "film file", 1, 1},
      {Command::denoise, "denoise", "denoise FILE -o FILE", "denoise a film file", "film file", 1, 1},
      {Command::merge, "merge", "merge FILM... -o FILE", "merge films of parts of a render", "film file", 1,
       kUnlimited},
      {Command::bench, "bench",
       "bench SCENE... | table1 | accel SCENE... | rays SCENE... | compare OLD.json NEW.json | error RUNS.json...",
       "time renders of scenes, acceleration structures (table1: on the built-in scenes mirror and balls) or rays "
       "alone, compare two of the resulting reports, or compare the errors of renderers in equal time",
       "benchmark", 1, kUnlimited},
      {Command::tune, "tune", "tune [SCENE...]",
       "measure which settings are fastest on a device, and store them as the meaning of `auto`", "scene", 0,
       kUnlimited},
      {Command::kernels, "kernels", "kernels [SCENE...] | compare OLD.json NEW.json",
       "compile the kernels of scenes without rendering, and report what the driver makes of them, or compare two of "
       "the resulting reports",
       "scene", 0, kUnlimited},
      {Command::report, "report", "report RESULTS.json...",
       "compare devices by the results that the kit measured on them", "results file", 1, kUnlimited},
  }};
  return table;
}

const CommandInfo& commandInfo(Command command) {
  for (const CommandInfo& info : commandTable()) {
    if (info.command == command) return info;
  }
  throw InternalError("a command is missing from the table of commands");
}

}  // namespace candela::cli
