// Compares the option table with the documented names, values and defaults.
#include "host/cli/option_table.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <optional>
#include <set>
#include <sstream>

#include "host/cli/commands.h"
#include "host/tune/dimensions.h"

namespace candela::cli {
namespace {

// The first row of the name, or the one for a command.
const Option& find(const std::string& name, std::optional<Command> command = std::nullopt) {
  const auto& table = optionTable();
  const auto found = std::ranges::find_if(
      table, [&](const Option& o) { return o.name() == name && (!command || o.isFor(*command)); });
  REQUIRE(found != table.end());
  return *found;
}

}  // namespace

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
      {"--seed", "N", "0"},
      {"--size", "WxH", "the scene's"},
      {"--film-scale", "N", "auto"},
      {"--max-depth", "N", "64; whitted: 4"},
      {"--rr-start", "N", "4"},
      {"--integrator", "path|whitted|ao|normal|albedo|depth|id|cost", "path"},
      {"--ao-distance", "D", "auto"},
      {"--nee", "on|off", "on"},
      {"--sampler", "independent|stratified|sobol", "sobol"},
      {"--filter", "box|tent", "box"},
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
      {"--env", "FILE", "none"},
      {"--env-rotate", "DEG", "0"},
      {"--env-scale", "S", "1"},
      {"--camera", "NAME|N", "the first, else none"},
      {"--time", "SECONDS", "the pose at rest"},
      {"--animation", "NAME|N", "the first"},
      {"--device", "cpu|N|SUBSTRING", "the best GPU"},
      {"--kernel", "auto|megakernel|wavefront", "auto"},
      {"--workgroup", "XxY", "auto"},
      {"--tile", "WxH", "auto"},
      {"--segments-per-dispatch", "N", "auto"},
      {"--hang-timeout", "TIME", "auto"},
      {"--fallback", "none|cpu", "none"},
      {"--memory", "SIZE", "the machine's"},
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
      {"--crop", "X,Y,W,H", "the image"},
      {"-o,--output", "FILE", "", Command::merge},
      {"--mixed-devices", "", ""},
      {"--partial", "", ""},
      {"--exposure", "STOPS", "0"},
      {"--tolerance", "T", ""},
      {"--diff", "FILE", ""},
      {"--flip", "FILE", ""},
      {"--alpha", "A", "0.0001", Command::compare},
      {"--alpha", "A", "0.0001", Command::verify},
      {"--bias", "FRACTION", "0.05 %, or 3 times what rounding may cause; 0.5 % with --test independent"},
      {"--test", "paired|independent", "paired"},
      {"--time-limit", "TIME", "none", Command::verify},
      {"--junit", "FILE", ""},
      {"--explain", "", ""},
      {"--device", "N|SUBSTRING", "all", Command::devices},
      {"--cases", "GLOB", ""},
      {"--variants", "", ""},
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
      {"--threshold", "FRACTION", "0.05"},
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

TEST_CASE("an option prints the value that it was given") {
  const std::vector<std::pair<std::string, std::vector<std::string>>> samples{
      {"--spp", {"0", "1", "16", "1073741824"}},
      {"--seed", {"0", "4294967295"}},
      {"--size", {"1x1", "65535x65535"}},
      {"--max-depth", {"1", "5000"}},
      {"--rr-start", {"0", "9"}},
      {"--pixel-origin", {"corner", "centre"}},
      {"--light-size", {"0.25", "3"}},
      {"--integrator", {"whitted", "ao", "normal", "albedo", "depth", "id", "cost", "path"}},
      {"--ao-distance", {"0.25", "1e-30", "auto"}},
      {"--nee", {"off", "on"}},
      {"--sampler", {"independent", "stratified", "sobol"}},
      {"--filter", {"tent", "box"}},
      {"--lens", {"square", "disc"}},
      {"--accel", {"none", "grid", "bvh"}},
      {"--bvh-split", {"midpoint", "sah"}},
      {"--bvh-quality", {"fast", "high", "default"}},
      {"--grid-density", {"0.5", "64"}},
      {"--device", {"cpu", "llvmpipe"}},
      {"--kernel", {"megakernel", "wavefront", "auto"}},
      {"--workgroup", {"16x4", "auto"}},
      {"--tile", {"7x9", "auto"}},
      {"--segments-per-dispatch", {"1", "auto"}},
      {"--threads", {"2"}},
      {"--aov", {"normal,uv", "none", "crypto-object,crypto-material"}},
      {"--display-server", {"localhost:14158", "[::1]:80", "none"}},
      {"--tonemap", {"none", "srgb", "aces", "aces-hill", "agx", "pbr-neutral"}},
      {"--clamp-indirect", {"10", "0.5", "off"}},
      {"--noise-threshold", {"0.2", "1", "off"}},
      {"--background", {"none", "colour", "env"}},
      {"--env", {"a b.hdr", "white", "sun:30,120,3"}},
      {"--env-rotate", {"-90", "12.5"}},
      {"--env-scale", {"0", "2.5"}},
      {"--exposure", {"-1.5", "2", "auto"}},
      {"--tolerance", {"0.001"}},
      {"--checkpoint-every", {"0s", "90s", "0.5s"}},
      {"--samples", {"0:1", "16:64"}},
      {"--crop", {"0,0,1,1", "12,34,56,78"}},
      {"--cases", {"leaf.*"}},
      {"--jobs", {"1", "16", "auto"}},
      {"--shuffle", {"0", "7", "off"}},
      {"--timeout", {"0.5s", "90s"}},
      {"--allow-path", {"/a", "b c"}}};
  Arguments arguments;
  for (const auto& [name, values] : samples) {
    for (const std::string& value : values) {
      INFO(name << " " << value);
      REQUIRE(find(name).apply(arguments, value));
      CHECK(find(name).show(arguments).back() == value);
    }
  }
}

TEST_CASE("mattes have short names, and all layers have one") {
  Arguments arguments;
  const auto layersOf = [&](const char* list) {
    REQUIRE(find("--aov").apply(arguments, list));
    return find("--aov").show(arguments).back();
  };
  CHECK(layersOf("id,material,normal") == "normal,crypto-object,crypto-material");
  CHECK(layersOf("all") == fmt::format("{}", fmt::join(image::layerNames(), ",")));
  CHECK_FALSE(find("--aov").apply(arguments, "all,ids"));
}

TEST_CASE("the curve pbr-neutral has a second name") {
  Arguments arguments;
  REQUIRE(find("--tonemap").apply(arguments, "neutral"));
  CHECK(find("--tonemap").show(arguments).back() == "pbr-neutral");
}

TEST_CASE("a value out of range or of another kind is refused") {
  const std::vector<std::pair<std::string, std::vector<std::string>>> bad{
      {"--spp", {"-1", "1.5", "", "16x", "4294967296", "1e3", " 4"}},
      {"--seed", {"-1", "4294967296"}},
      {"--size", {"0x1", "1x0", "65536x1", "1x65536", "12", "x", "1x", "x1", "1x1x1"}},
      {"--max-depth", {"0"}},
      {"--light-size", {"-1", "inf"}},
      {"--integrator", {"Path", "normals"}},
      {"--ao-distance", {"0", "-1", "nan", "inf", "1e31"}},
      {"--nee", {"yes", ""}},
      {"--sampler", {"Sobol", "sob"}},
      {"--kernel", {"Wavefront", "mega"}},
      {"--workgroup", {"0x8", "1025x1"}},
      {"--accel", {"kd", "octree", ""}},
      {"--bvh-split", {"median"}},
      {"--bvh-quality", {"standard", "best"}},
      {"--grid-density", {"0", "-1", "65", "nan", "two"}},
      {"--threads", {"1025"}},
      {"--exposure", {"nan", "inf", "65", "1,5"}},
      {"--clamp-indirect", {"0", "-1", "inf", "on"}},
      {"--noise-threshold", {"0", "-1", "inf", "on"}},
      {"--background", {"", "None", "sky"}},
      {"--env", {""}},
      {"--env-rotate", {"361", "nan"}},
      {"--env-scale", {"-1", "inf"}},
      {"--tolerance", {"-1", "nan"}},
      {"--checkpoint-every", {"-1s", "s", "", "1d", "nan", "inf", "60 s"}},
      {"--samples", {"1:1", "2:1", "1", ":", "0:", ":4", "-1:4", "0:4:8", "0:1073741825"}},
      {"--crop", {"0,0,0,1", "0,0,1,0", "0,0,1", "0,0,1,1,", "0,0,1,1,1", "65536,0,1,1", "-1,0,1,1", ",,,"}},
      {"--json", {""}},
      {"--output", {""}}};
  for (const auto& [name, values] : bad) {
    for (const std::string& value : values) {
      INFO(name << " " << value);
      Arguments arguments;
      CHECK_FALSE(find(name).apply(arguments, value));
    }
  }
}

TEST_CASE("a duration may have a unit, and prints in seconds") {
  Arguments arguments;
  for (const auto& [word, seconds] :
       std::vector<std::pair<std::string, double>>{{"90", 90}, {"90s", 90}, {"1.5min", 90}, {"2h", 7200}, {"0", 0}}) {
    REQUIRE(find("--checkpoint-every").apply(arguments, word));
    CHECK(arguments.checkpointEvery == seconds);
  }
  CHECK(find("--checkpoint-every").show(arguments) == std::vector<std::string>{"0s"});
}

TEST_CASE("settings print as the command line that states them") {
  Arguments arguments;
  arguments.request.settings.image.seed = 7;
  arguments.request.settings.image.oneSided = true;
  CHECK(commandLineOf(arguments, OptionGroup::image, true) == "--seed 7 --one-sided");
  arguments.device = "Radeon (TM) 'X'";
  CHECK(commandLineOf(arguments, OptionGroup::execution, true) == "--device 'Radeon (TM) '\\''X'\\'''");
  arguments.loadOptions.allowedPaths = {"/a", "/b"};
  CHECK(commandLineOf(arguments, OptionGroup::sceneFile, true) == "--allow-path /a --allow-path /b");
  arguments.loadOptions = {.camera = "near eye", .time = 0.5};
  CHECK(commandLineOf(arguments, OptionGroup::sceneFile, true) == "--camera 'near eye' --time 0.5");
}

TEST_CASE("every tuned option belongs to tracing, and has auto and all values that are tried") {
  for (const tune::Dimension& dimension : tune::dimensionTable()) {
    const std::string name = "--" + dimension.option;
    const Option& option = find(name);
    CHECK(option.isFor(Command::render));
    CHECK(option.group == OptionGroup::execution);
    CHECK(option.defaultText == "auto");
    Arguments arguments;
    for (const tune::Value& value : dimension.values) {
      CHECK(option.apply(arguments, value.name));
      CHECK(option.show(arguments) == std::vector{value.name});
    }
  }
}

}  // namespace candela::cli
