// Every dialect in circulation is read as its programs interpret it.
#include <algorithm>
#include <catch2/catch.hpp>
#include <sstream>
#include <vector>

#include "host/formats/nff/nff_material.h"
#include "tests/formats/loading/triangles.h"
#include "tests/formats/nff/scene_text.h"

namespace candela::scene {
namespace {

// Expected meaning of the numbers of an `f` line. The scene's material must equal the material made from it.
NffMaterial materialOf(const std::string& line) {
  std::istringstream words(line.substr(1));
  std::vector<float> numbers;
  for (float number; words >> number;) numbers.push_back(number);
  const NffMaterial material = readNffMaterial(numbers);
  CHECK(sceneOf(line + "\n").materials.at(0) == fromNff(material));
  return material;
}
PointLight pointLightOf(const std::string& line) { return sceneOf(line + "\n").pointLights.at(0); }

}  // namespace

TEST_CASE("the entries of a view may be in any order and on any lines") {
  const Scene scene = sceneOf("v resolution 640\n 480 hither 1\nup 0 0 1 at\n1 2 3 from 4 5 6\nangle 30");
  REQUIRE(scene.camera);
  CHECK(scene.camera->from == glm::vec3(4, 5, 6));
  CHECK(scene.camera->at == glm::vec3(1, 2, 3));
  CHECK(scene.camera->up == glm::vec3(0, 0, 1));
  CHECK(scene.camera->angle == 30);
  CHECK(scene.camera->hither == 1);
  CHECK(scene.camera->width == 640);
  CHECK(scene.camera->height == 480);
  CHECK(scene.camera->aperture == 0);
  CHECK(scene.camera->focal == 1);
}

TEST_CASE("the 2016 dialect of the view is read, its view distance with a warning") {
  const LoadedScene loaded = load(
      "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nfocal 1.5\nview 2\napperture 3\nangle 45\nhither 1\nresolution 8 8\n");
  CHECK(loaded.scene.camera->aperture == 3);
  CHECK(loaded.scene.camera->focal == 1.5f);
  CHECK(warningWith(loaded, "view plane").line == 6);
}

TEST_CASE("the dialect with camera, eye, mat and names of structures is read") {
  const Scene scene = sceneOf(
      "camera\neye 0 0 5\nat 0 0 0\nup 0 1 0\nangle 45\nhither 1\nresolution 8 8\naperture 2\nfocal 1.25\n"
      "accel bvh\nmat .1 .2 .3 .4 .5 .6 .7 .8 9 .1 1.5\ns 0 0 0 1\n");
  CHECK(scene.camera->from == glm::vec3(0, 0, 5));
  CHECK(scene.camera->aperture == 2);
  CHECK(scene.requestedAccel == RequestedAccel::bvh);
  CHECK(scene.materials.at(0).glossy->colour == glm::vec3(.5f, .6f, .7f));
}

TEST_CASE("8 numbers are NFF") {
  const NffMaterial m = materialOf("f .1 .2 .3 .4 .5 30 .6 1.5");
  CHECK(m.diffuse == glm::vec3(.1f, .2f, .3f));
  CHECK(m.kd == .4f);
  CHECK(m.ks == .5f);
  CHECK(m.shine == 30);
  CHECK(m.t == .6f);
  CHECK(m.ior == 1.5f);
  CHECK(m.specular == glm::vec3(1));
  CHECK(m.ka == 0);
  CHECK(m.emission == glm::vec3(0));
}

TEST_CASE("9 numbers are NFF with Ka") {
  const NffMaterial m = materialOf("f .1 .2 .3 .4 .5 30 .6 1.5 .25");
  CHECK(m.ior == 1.5f);
  CHECK(m.ka == .25f);
}

TEST_CASE("11, 12, 14 and 15 numbers are P3F, with roughness and emission if given") {
  for (const std::string tail : {"", " .7", " 4 5 6", " .7 4 5 6"}) {
    CAPTURE(tail);
    const NffMaterial m = materialOf("f .1 .2 .3 .4 .5 .6 .7 .8 90 .9 1.5" + tail);
    CHECK(m.diffuse == glm::vec3(.1f, .2f, .3f));
    CHECK(m.kd == .4f);
    CHECK(m.specular == glm::vec3(.5f, .6f, .7f));
    CHECK(m.ks == .8f);
    CHECK(m.shine == 90);
    CHECK(m.t == .9f);
    CHECK(m.ior == 1.5f);
    CHECK(m.roughness == (tail.starts_with(" .7") ? .7f : 0.f));
    CHECK(m.emission == (tail.ends_with("6") ? glm::vec3(4, 5, 6) : glm::vec3(0)));
  }
}

TEST_CASE("11 numbers that cannot be P3F are NFF with emission") {
  // The 6th is a Shine above 1; or the 8th an index above 1; or the 10th an emission above 1.
  CHECK(materialOf("f 1 1 1 .5 .5 30 0 1 0 0 0").shine == 30);
  CHECK(materialOf("f 1 1 1 .5 .5 1 .25 1.5 0 0 0").ior == 1.5f);
  const NffMaterial m = materialOf("f 0 0 0 1 0 1 0 1 6 7 8");
  CHECK(m.emission == glm::vec3(6, 7, 8));
  CHECK(m.ior == 1);
}

TEST_CASE("11 numbers that fit both readings are P3F") {
  const NffMaterial m = materialOf("f 0 0 0 1 0 1 0 1 6 1 8");
  CHECK(m.specular == glm::vec3(0, 1, 0));
  CHECK(m.ks == 1);
  CHECK(m.shine == 6);
  CHECK(m.t == 1);
  CHECK(m.ior == 8);
  CHECK(m.emission == glm::vec3(0));
}

TEST_CASE("an opaque material with index of refraction 0 is read unchanged") {
  const NffMaterial m = materialOf("f 1 .85 .7 .3 .6 3.0827 0 0");
  CHECK(m.t == 0);
  CHECK(m.ior == 0);
}

TEST_CASE("a light has 3, 6 or 7 numbers") {
  CHECK(pointLightOf("l 1 2 3").position == glm::vec3(1, 2, 3));
  CHECK(pointLightOf("l 1 2 3").colour == glm::vec3(1));
  CHECK(pointLightOf("l 1 2 3 .1 .2 .3").colour == glm::vec3(.1f, .2f, .3f));
  CHECK(pointLightOf("l 1 2 3 2 .25 .5 1").colour == glm::vec3(.5f, 1, 2));
  CHECK(pointLightOf("light punctual 1 2 3 .1 .2 .3").colour == glm::vec3(.1f, .2f, .3f));
}

TEST_CASE("optional numbers never continue on the next line, but required ones may") {
  const Scene scene = sceneOf("l 1 2\n3\ns 1 2 3\n4\nc\n0 0 0 1\n0 0 1 1\np 3 0 0 0 1 0 0\n0 1 0\n");
  CHECK(scene.pointLights.at(0).colour == glm::vec3(1));
  CHECK(scene.spheres.at(0).radius == 4);
  CHECK(scene.cones.at(0).apexRadius == 1);
  CHECK(trianglesOf(scene).size() == 1);
  const auto errors = errorsOf("l 1 2 3\n.1 .2 .3\n");
  REQUIRE(errors.size() == 1);
  CHECK(errors[0].line == 2);
}

TEST_CASE("an area light in each of its forms is two emitting black triangles") {
  for (const std::string line : {"al 1 0 0 2 0 0 0 3 0 4 5 6", "la 1 0 0 2 0 0 0 3 0 4 5 6",
                                 "light quad 1 0 0 4 5 6 2 0 0 0 3 0 8", "light quad 1 0 0 4 5 6 2 0 0 0 3 0"}) {
    CAPTURE(line);
    const Scene scene = sceneOf(line + "\n");
    REQUIRE(scene.primitives.size() == 2);
    REQUIRE(trianglesOf(scene).size() == 2);
    const Material& lamp = scene.materials.at(scene.primitives[1].material);
    CHECK(lamp.diffuse->colour == glm::vec3(0));
    CHECK(lamp.diffuse->weight == 1);
    CHECK(lamp.emission == glm::vec3(4, 5, 6));
    CHECK(trianglesOf(scene).at(0).p[1] == glm::vec3(3, 0, 0));
    CHECK(trianglesOf(scene).at(1).p[1] == glm::vec3(3, 3, 0));
    CHECK(trianglesOf(scene).at(1).p[2] == glm::vec3(1, 3, 0));
  }
  CHECK(sceneOf("la 0 0 0 1 0 0 0 1 0\n").materials.at(0).emission == glm::vec3(1));
}

TEST_CASE("area lights of one colour share a material, whatever is between them") {
  const Scene scene = sceneOf(
      "al 0 0 0 1 0 0 0 1 0 1 2 3\nf 1 0 0 1 0 1 0 1\ns 0 0 0 1\nal 9 0 0 1 0 0 0 1 0 1 2 3\n"
      "al 18 0 0 1 0 0 0 1 0 3 2 1\n");
  REQUIRE(scene.primitives.size() == 7);
  CHECK(scene.materials.size() == 3);
  CHECK(scene.primitives[3].material == scene.primitives[0].material);
  CHECK(scene.materials[scene.primitives[5].material].emission == glm::vec3(3, 2, 1));
  CHECK(scene.primitives[2].material != scene.primitives[0].material);
}

TEST_CASE("an area light does not change the current material") {
  const Scene scene = sceneOf("f 1 0 0 1 0 1 0 1\nal 0 0 0 1 0 0 0 1 0 1 1 1\ns 0 0 0 1\n");
  CHECK(scene.materials.at(scene.primitives.back().material).diffuse->colour == glm::vec3(1, 0, 0));
}

TEST_CASE("a moving sphere is read at its first centre, with a warning") {
  for (const std::string line : {"ms 1 2 3 4 5 6 7", "ms 1 2 3 4 5 6 7 0 1"}) {
    const LoadedScene loaded = load(line);
    CHECK(loaded.scene.spheres.at(0).centre == glm::vec3(1, 2, 3));
    CHECK(loaded.scene.spheres.at(0).radius == 7);
    CHECK(warningWith(loaded, "motion is not traced").line == 1);
  }
}

TEST_CASE("spp 0 is preserved, and a warning explains its meaning") {
  const LoadedScene loaded = load("spp 0\n");
  CHECK(loaded.scene.requestedSamples == 0u);
  const auto says = [](const Diagnostic& d) { return toString(d).find("centre of each pixel") != std::string::npos; };
  CHECK(std::ranges::count_if(loaded.warnings, says) == 1);
}

TEST_CASE("background, structure and samples are preserved, and a warning says that spp is a total") {
  const LoadedScene loaded = load("b .1 .2 .3\naccel 1\nspp 64\n");
  CHECK(loaded.scene.background == glm::vec3(.1f, .2f, .3f));
  CHECK(loaded.scene.requestedAccel == RequestedAccel::grid);
  CHECK(loaded.scene.requestedSamples == 64u);
  CHECK(warningWith(loaded, "64 samples per pixel in total").line == 3);
  CHECK(sceneOf("bclr 1 2 3\n").background == glm::vec3(1, 2, 3));
}

TEST_CASE("CRLF, single CR, tabs, comments, a byte order mark and a missing final newline are accepted") {
  const Scene scene = sceneOf("\xef\xbb\xbf# head\r\n\r\n\tf\t1 1 1 1 0 1 0 1# tail\r\ns 0 0 0 1 \t\r# cr\rs 1 0 0 1");
  CHECK(scene.spheres.size() == 2);
  CHECK(scene.materials.size() == 1);
}

TEST_CASE("several statements may share a line") { CHECK(sceneOf("s 0 0 0 1 s 2 0 0 1\n").spheres.size() == 2); }

TEST_CASE("an object before any material is diffuse white, with a warning") {
  const LoadedScene loaded = load("s 0 0 0 1\nf 1 0 0 1 0 1 0 1\ns 1 0 0 1\n");
  CHECK(warningWith(loaded, "before any material").line == 1);
  CHECK(loaded.scene.primitives[0].material == 0);
  CHECK(loaded.scene.materials[0] == fromNff({}));
  CHECK(loaded.scene.primitives[1].material == 1);
}

TEST_CASE("lenient reading skips unknown statements and warns once of each kind") {
  const LoadedScene loaded = loadLenient(
      "From: a b c\nSubject: 1 2\n\nasdabb 1 2 3\n4 5 6\nasdabb 2\nWall\ns 0 0 0 1 9\nl 0 0 0 5\n"
      "f 1 1 1 .5\ns 1 0 0 1\nf 1 1 1 1 0 1 0 1 .25 9\ns 2 0 0 1\ns 0 0 0 0\n");
  CHECK(loaded.scene.spheres.size() == 3);
  CHECK(warningWith(loaded, "\"From:\"").line == 1);
  CHECK(contains(warningWith(loaded, "\"asdabb\"").message, "(and 1 more like it)"));
  CHECK(warningWith(loaded, "\"asdabb\"").line == 4);
  CHECK(warningWith(loaded, "\"Wall\"").line == 7);
  CHECK(warningWith(loaded, "unexpected number \"9\"").column == 11);
  CHECK(warningWith(loaded, "3, 6 or 7 numbers").line == 9);
  CHECK(warningWith(loaded, "missing numbers have their defaults").line == 10);
  CHECK(warningWith(loaded, "not 10").line == 12);
  CHECK(warningWith(loaded, "radius must not be 0").line == 14);
  CHECK(loaded.scene.materials.at(1) == fromNff({.kd = .5f}));
  CHECK(loaded.scene.materials.at(2).whitted->ka == .25f);
}

TEST_CASE("lenient reading completes a short view") {
  const LoadedScene loaded = loadLenient("v\nfrom 0 0 5\nat 0 0 0\n");
  CHECK(loaded.scene.camera->angle == 45);
  CHECK(loaded.scene.camera->width == 512);
  CHECK(warningWith(loaded, "lacks \"angle\"").line == 1);
  CHECK(errorsOf("v\nfrom 0 0 5\n", {.lenient = true}).at(0).message == "this view lacks \"at\"");
}

TEST_CASE("lenient reading still refuses WorldToolKit's NFF and wrong values") {
  CHECK(contains(errorsOf("NFF\n", {.lenient = true}).at(0).message, "WorldToolKit"));
  CHECK(errorsOf("s 0 0 0 nan\n", {.lenient = true}).size() == 1);
}

TEST_CASE("unusual but harmless content causes warnings") {
  CHECK(warningWith(load("f 1 1 1 .5 .6 10 0 1\n"), "scales them to sum 1").line == 1);
  CHECK(warningWith(load("f 2 1 1 1 0 10 0 1\n"), "reflects more than it receives").line == 1);
  CHECK(warningWith(load("s 0 0 0 1\n"), "the image will be black").line == 0);
  CHECK(warningWith(load("b 1 1 1\n"), "no objects").line == 0);
  CHECK(warningWith(load("p 4\n0 0 0\n1 0 0\n1 1 1\n0 1 0\n"), "not flat").line == 1);
  CHECK(warningWith(load("p 4\n0 0 0\n1 0 0\n0 1 0\n1 2 0\n"), "crosses itself").line == 1);
  CHECK(warningWith(load("env no_such_folder\n"), "there is no folder").column == 5);
}

TEST_CASE("a valid scene with light causes no warnings") {
  const std::string lit = "f 1 1 1 1 0 1 0 1\ns 0 0 0 1\n";
  CHECK(load(lit + "b 1 1 1\n").warnings.empty());
  CHECK(load(lit + "l 0 0 9\n").warnings.empty());
  CHECK(load(lit + "f 0 0 0 1 0 0 0 0 1 0 1 1 1 1\ns 3 0 0 1\n").warnings.empty());
  CHECK(load(lit + "l 0 0 9\nf 1 1 1 .9 .1 1 0 1\n").warnings.empty());  // .9f + .1f rounds above 1
  CHECK(load(lit + "l 0 0 9\nf 1 1 1 1 .5 1 0 1\n").warnings.empty());   // Kd = 1 is diffuse, whatever Ks is
}

TEST_CASE("a scene without a view can be loaded, and is an error only if a view is needed") {
  const Scene scene = sceneOf("s 0 0 0 1\n");
  CHECK_FALSE(scene.camera);
  CHECK_THROWS_WITH(requireCamera(scene), Catch::Contains("test: the scene has no view"));
  CHECK_NOTHROW(requireCamera(sceneOf("v from 0 0 1 at 0 0 0 up 0 1 0 angle 45 hither 0 resolution 1 1")));
}

}  // namespace candela::scene
