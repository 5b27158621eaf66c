// The views as a user requests them, on the reference tracer.
#include <catch2/catch.hpp>

#include "host/image/image.h"
#include "tests/app/cli/run_program.h"
#include "tests/image/read_pixels8.h"

namespace candela {
namespace {

// A render of the small scene to both kinds of files.
struct Rendered {
  ProgramResult result;
  image::Image linear;
  image::Pixels8 shown;
};

Rendered renderView(const std::vector<std::string>& options) {
  const TemporaryFolder folder;
  const std::string exr = folder.path("a.exr");
  const std::string png = folder.path("a.png");
  std::vector<std::string> words{folder.write("a.p3f", smallScene()), "-o", exr, "-o", png, "--device", "cpu"};
  words.insert(words.end(), options.begin(), options.end());
  const ProgramResult result = runCandela(words);
  INFO(result.err);
  REQUIRE(result.exitCode == 0);
  return {result, image::readImage(exr), image::readPixels8(png)};
}

float scaleIn(const std::string& metadata) { return std::stof(metadata.substr(metadata.find("scale ") + 6)); }

}  // namespace

TEST_CASE("depth and cost are shown in false colours, with their scale in the file and on the terminal") {
  const Rendered depth = renderView({"--integrator", "depth", "--exposure", "0.5"});
  const std::string depthText = depth.linear.metadata.at("candela.falseColour");
  CHECK(contains(depthText, "depth, scale "));
  CHECK(depth.shown.rgb == toPixels8(depth.linear, {image::ToneMap::depth, 0, scaleIn(depthText)}).rgb);
  CHECK(contains(depth.result.err, "candela: depth: near is white, far is dark, middle grey stands for "));

  // Four primitives and no BVH: four steps for every ray.
  const Rendered cost = renderView({"--integrator", "cost"});
  CHECK(cost.linear.metadata.at("candela.falseColour") == "heat, scale 4");
  CHECK(cost.linear.at(3, 3) == glm::vec3(4));
  CHECK(cost.shown.rgb == toPixels8(cost.linear, {image::ToneMap::heat, 0, 4}).rgb);
  CHECK(contains(cost.result.err, "candela: cost: the palest colour stands for 4 steps\n"));
}

TEST_CASE("a requested tone curve takes precedence over false colours") {
  const Rendered depth = renderView({"--integrator", "depth", "--tonemap", "srgb", "--exposure", "-3"});
  CHECK(depth.linear.metadata.count("candela.falseColour") == 0);
  CHECK(depth.shown.rgb == toPixels8(depth.linear, {image::ToneMap::srgb, -3}).rgb);
  CHECK_FALSE(contains(depth.result.err, "middle grey"));
}

TEST_CASE("the other views are shown like light") {
  for (const char* view : {"ao", "normal", "albedo", "id"}) {
    const Rendered rendered = renderView({"--integrator", view, "--spp", "2"});
    CAPTURE(view);
    CHECK(rendered.linear.metadata.count("candela.falseColour") == 0);
    CHECK(contains(rendered.linear.metadata.at("candela.settings"), std::string("--integrator ") + view));
    CHECK(rendered.shown.rgb == toPixels8(rendered.linear, {}).rgb);
    CHECK(*std::max_element(rendered.shown.rgb.begin(), rendered.shown.rgb.end()) > 0);
  }
}

TEST_CASE("the option --ao-distance changes the image of ambient occlusion") {
  const image::Image near = renderView({"--integrator", "ao", "--ao-distance", "0.01"}).linear;
  const image::Image far = renderView({"--integrator", "ao", "--ao-distance", "10"}).linear;
  double nearSum = 0, farSum = 0;
  for (std::size_t i = 0; i < near.rgb.size(); ++i) {
    nearSum += near.rgb[i].x;
    farSum += far.rgb[i].x;
  }
  CHECK(nearSum > farSum);
}

TEST_CASE("comparing the costs of two tracers is refused with the reason") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const ProgramResult result = runCandela({"compare", scene, "--integrator", "cost"});
  CHECK(result.exitCode == 1);
  CHECK(contains(result.err, "acceleration structures, which the two tracers build differently"));
}

}  // namespace candela
