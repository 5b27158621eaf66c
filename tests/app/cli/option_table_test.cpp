// Compares the option table with the documented names, values and defaults.
#include "host/app/cli/option_table.h"

#include <catch2/catch.hpp>
#include <map>
#include <set>
#include <sstream>

#include "host/app/cli/commands.h"
#include "host/measure/tune/dimensions.h"
#include "tests/app/cli/find_option.h"

namespace candela::cli {

TEST_CASE("every option has the documented name, value and default") {
  struct Promise {
    const char* names;
    const char* metavar;
    const char* defaultText;
    std::optional<Command> command = {};
  };
  const std::vector<Promise> promises{
      {"-o,--output", "FILE", ""},
      {"--spp", "N", "the scene's `spp`, else 16"},
      {"--seed", "N", "0", Command::render},
      {"--seed", "N", "0", Command::verify},
      {"--size", "WxH", "the scene's"},
      {"--film-scale", "N", "auto"},
      {"--max-depth", "N", "the scene's, else 64; whitted: 4"},
      {"--rr-start", "N", "4"},
      {"--integrator", "path|whitted|ao|normal|albedo|depth|id|cost", "path"},
      {"--ao-distance", "D", "auto"},
      {"--nee", "on|off", "on"},
      {"--lights", "power|tree", "auto"},
      {"--sampler", "independent|stratified|sobol", "sobol"},
      {"--filter", "box|tent|gaussian|gaussian:S", "the scene's, else box"},
      {"--lens", "disc|square", "disc"},
      {"--pixel-origin", "centre|corner", "centre"},
      {"--light-size", "S", "0"},
      {"--accel", "none|grid|bvh", "the scene's `accel`, else bvh"},
      {"--bvh-split", "sah|midpoint", "sah"},
      {"--bvh-quality", "fast|default|high", "default"},
      {"--layout", "auto|bvh2|cwbvh", "auto"},
      {"--loads", "auto|texel|storage", "auto"},
      {"--grid-density", "M", "2"},
      {"--clamp-indirect", "V", "off"},
      {"--noise-threshold", "T", "off"},
      {"--background", "env|colour|none", "env"},
      {"--aov-through-specular", "", ""},
      {"--one-sided", "", ""},
      {"--lenient", "", ""},
      {"--allow-path", "DIR", ""},
      {"-D,--define", "NAME=VALUE", ""},
      {"--env", "FILE", "none"},
      {"--env-rotate", "DEG", "0"},
      {"--env-scale", "S", "1"},
      {"--camera", "NAME|N", "the first, else none"},
      {"--time", "SECONDS", "the pose at rest"},
      {"--animation", "NAME|N", "the first"},
      {"--orbit", "DEG", "0"},
      {"--frames", "A:B", "none"},
      {"--fps", "F", "24"},
      {"--turntable", "N", "none"},
      {"--device", "cpu|N|SUBSTRING", "the best GPU"},
      {"--kernel", "auto|megakernel|wavefront", "auto"},
      {"--workgroup", "XxY", "auto"},
      {"--tile", "WxH", "auto"},
      {"--segments-per-dispatch", "N", "auto"},
      {"--hang-timeout", "TIME", "auto"},
      {"--fallback", "none|cpu", "none"},
      {"--memory", "SIZE", "that of the machine or of its control group"},
      {"--untuned", "", ""},
      {"--no-cache", "", ""},
      {"-t,--threads", "N", "0"},
      {"--aov", "LAYERS", "none"},
      {"--tonemap", "none|srgb|aces|aces-hill|agx|pbr-neutral|neutral", "srgb"},
      {"--checkpoint", "FILE", ""},
      {"--checkpoint-every", "TIME", "60s"},
      {"--resume", "FILE", ""},
      {"--resume-anyway", "", ""},
      {"--display-server", "HOST:PORT", "none"},
      {"--denoise", "", "", Command::render},
      {"--denoise", "", "", Command::denoise},
      {"--time-limit", "TIME", "none", Command::render},
      {"--samples", "A:B", "all"},
      {"--crop", "X,Y,W,H", "the scene's, else the image"},
      {"-o,--output", "FILE", "", Command::merge},
      {"--mixed-devices", "", ""},
      {"--partial", "", ""},
      {"--exposure", "STOPS", "0"},
      {"--with", "FILE", ""},
      {"--paired", "", ""},
      {"--with-variance", "FILE", ""},
      {"--with-spp", "N", "that of the file"},
      {"--set-spp", "N", "that of the files"},
      {"--tolerance", "T", ""},
      {"--channels", "NAMES", ""},
      {"--diff", "FILE", ""},
      {"--flip", "FILE", ""},
      {"--alpha", "A", "0.0001", Command::compare},
      {"--alpha", "A", "0.0001", Command::verify},
      {"--bias", "FRACTION", "1 %", Command::compare},
      {"--bias", "FRACTION",
       "1 %, and the run continues to 0.05 % or 32 samples per pixel; 0.5 % with --test independent", Command::verify},
      {"--allow-undecided", "", ""},
      {"--test", "paired|independent", "paired"},
      {"--time-limit", "TIME", "none", Command::verify},
      {"--junit", "FILE", ""},
      {"--explain", "", ""},
      {"--device", "N|SUBSTRING", "all", Command::devices},
      {"--cases", "GLOB", ""},
      {"--variants", "", ""},
      {"--compile-only", "", ""},
      {"--list", "", ""},
      {"--seed", "N", "0", Command::conformance},
      {"--alpha", "A", "1e-05", Command::conformance},
      {"--jobs", "N", "auto"},
      {"--shuffle", "N", "off"},
      {"--timeout", "TIME", "60s"},
      {"--baseline", "FILE", ""},
      {"--skips", "FILE", ""},
      {"--flakes", "FILE", ""},
      {"--csv", "FILE", ""},
      {"--capture", "FOLDER", ""},
      {"-o,--output", "FOLDER", "", Command::capture},
      {"--pixel", "X,Y", "", Command::capture},
      {"--expect", "DEVICE", ""},
      {"--shrink-time", "TIME", "60s"},
      {"--pixel", "X,Y", "the pixel that differs most", Command::explain},
      {"--sample", "N", "0"},
      {"--repeat", "N", "3"},
      {"--sweep", "NAME=V,V,...", ""},
      {"--error", "N", "0"},
      {"--threshold", "FRACTION", "0.05", Command::bench},
      {"--all-kernels", "", ""},
      {"--threshold", "FRACTION", "0.05", Command::kernels},
      {"--markdown", "FILE", ""},
      {"--svg", "FILE", ""},
      {"--size", "WxH", "auto", Command::tune},
      {"--spp", "N", "auto", Command::tune},
      {"--dry-run", "", ""},
      {"-o,--output", "FILE", "-", Command::generate},
      {"--size", "N", "the kind's", Command::generate},
      {"--depth", "N", "all", Command::boxes},
      {"--spp", "N", "4096", Command::view},
      {"--show", "device|reference|split|difference", "device"},
      {"--layer", "LAYER", "picture"},
      {"--stats", "", ""},
      {"--json", "FILE", ""},
      {"--strict", "", ""},
      {"--report", "FILE", ""},
      {"-q,--quiet", "", ""},
      {"-v,--verbose", "", ""},
      {"--version", "", ""},
      {"-h,--help", "", ""}};
  CHECK(optionTable().size() == promises.size());
  for (const Promise& promise : promises) {
    const std::string names = promise.names;
    const std::string lastName = names.substr(names.rfind(',') + 1);
    const Option& option = find(lastName, promise.command);
    CHECK(option.names == names);
    CHECK(option.metavar == promise.metavar);
    CHECK(option.defaultText == promise.defaultText);
    CHECK_FALSE(option.help.empty());
  }
}

TEST_CASE("each command has arguments of its own, and an option reads those of no other command") {
  for (const CommandInfo& info : commandTable()) {
    const Arguments arguments = defaultArguments(info.command);
    CHECK(commandOf(arguments) == info.command);
    for (const Option& option : optionTable()) {
      INFO(info.name << " " << option.name());
      if (option.isFor(info.command)) CHECK(valuesOf(arguments, option.name()) == option.show(arguments));
    }
  }
  CHECK_THROWS_AS(find("--partial").show(RenderArguments()), std::bad_variant_access);
  CHECK(valuesOf(RenderArguments(), "--partial").empty());
}

TEST_CASE("no command has two options with the same name") {
  for (const CommandInfo& info : commandTable()) {
    std::set<std::string> names;
    for (const Option& option : optionTable()) {
      if (!option.isFor(info.command)) continue;
      std::istringstream list(option.names);
      for (std::string name; std::getline(list, name, ',');) {
        INFO(info.name << " " << name);
        CHECK(names.insert(name).second);
      }
    }
  }
}

TEST_CASE("every tuned option belongs to tracing, and has auto and all values that are tried") {
  for (const tune::Dimension& dimension : tune::dimensionTable()) {
    const std::string name = "--" + dimension.option;
    const Option& option = find(name);
    CHECK(option.isFor(Command::render));
    CHECK(option.group == OptionGroup::execution);
    CHECK(option.defaultText == "auto");
    Arguments arguments = RenderArguments();
    for (const tune::Value& value : dimension.values) {
      CHECK(option.apply(arguments, value.name));
      CHECK(option.show(arguments) == std::vector{value.name});
    }
  }
}

}  // namespace candela::cli
