// The values of options: what is accepted, and how it is printed.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "tests/app/cli/find_option.h"

namespace candela::cli {

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
      {"--filter", {"tent", "gaussian:0.7", "gaussian:0.5", "gaussian:100", "box"}},
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
      {"--allow-path", {"/a", "b c"}},
      {"--define", {"spp=4", "name=a b"}}};
  for (const auto& [name, values] : samples) {
    Arguments arguments = argumentsWith(find(name));
    for (const std::string& value : values) {
      INFO(name << " " << value);
      REQUIRE(find(name).apply(arguments, value));
      CHECK(find(name).show(arguments).back() == value);
    }
  }
}

TEST_CASE("mattes have short names, and all layers have one") {
  Arguments arguments = RenderArguments();
  const auto layersOf = [&](const char* list) {
    REQUIRE(find("--aov").apply(arguments, list));
    return find("--aov").show(arguments).back();
  };
  CHECK(layersOf("id,material,normal") == "normal,crypto-object,crypto-material");
  CHECK(layersOf("all") == fmt::format("{}", fmt::join(image::layerNames(), ",")));
  CHECK_FALSE(find("--aov").apply(arguments, "all,ids"));
}

TEST_CASE("a Gaussian filter has a standard deviation of half a pixel unless another one is stated") {
  Arguments arguments = RenderArguments();
  REQUIRE(find("--filter").apply(arguments, "gaussian"));
  CHECK(find("--filter").show(arguments).back() == "gaussian:0.5");
}

TEST_CASE("the curve pbr-neutral has a second name") {
  Arguments arguments = RenderArguments();
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
      {"--filter",
       {"", "Gaussian", "gaussian:", "gaussian:0", "gaussian:-1", "gaussian:101", "gaussian:nan", "gaussian:1,2",
        "tent:1"}},
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
      Arguments arguments = argumentsWith(find(name));
      CHECK_FALSE(find(name).apply(arguments, value));
    }
  }
}

TEST_CASE("a duration may have a unit, and prints in seconds") {
  Arguments arguments = RenderArguments();
  for (const auto& [word, seconds] :
       std::vector<std::pair<std::string, double>>{{"90", 90}, {"90s", 90}, {"1.5min", 90}, {"2h", 7200}, {"0", 0}}) {
    REQUIRE(find("--checkpoint-every").apply(arguments, word));
    CHECK(std::get<RenderArguments>(arguments).film.checkpointEvery == seconds);
  }
  CHECK(find("--checkpoint-every").show(arguments) == std::vector<std::string>{"0s"});
}

TEST_CASE("settings print as the command line that states them") {
  RenderArguments arguments;
  arguments.request.image.seed = 7;
  arguments.request.image.oneSided = true;
  CHECK(commandLineOf(arguments, OptionGroup::image, true) == "--seed 7 --one-sided");
  arguments.device = "Radeon (TM) 'X'";
  CHECK(commandLineOf(arguments, OptionGroup::execution, true) == "--device 'Radeon (TM) '\\''X'\\'''");
  arguments.loadOptions.allowedPaths = {"/a", "/b"};
  CHECK(commandLineOf(arguments, OptionGroup::sceneFile, true) == "--allow-path /a --allow-path /b");
  arguments.loadOptions = {.camera = "near eye", .time = 0.5};
  CHECK(commandLineOf(arguments, OptionGroup::sceneFile, true) == "--camera 'near eye' --time 0.5");
}

}  // namespace candela::cli
