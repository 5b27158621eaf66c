// The report of a scene: counts, bounds, lights, materials, as text and as JSON.
#include "host/formats/scene_report.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/formats/nff/scene_text.h"

namespace candela::scene {
namespace {

const std::string kScene =
    "b .1 .2 .3\nv from 0 0 9 at 0 0 0 up 0 1 0 angle 45 hither 1 resolution 64 32\naccel 1\n"
    "f 1 1 1 1 0 1 0 1\np 4 0 0 0 4 0 0 4 4 0 0 4 0\ns -3 0 0 1\n"   // diffuse
    "f 1 1 1 0 1 1 0 1\npl 0 0 0 1 0 0 0 1 0\n"                      // mirror
    "f 1 1 1 0 0 1 1 1.5\nc 0 0 0 2  0 0 5 1\n"                      // dielectric
    "f 1 1 1 .5 .5 9 0 1\nbox 0 0 -2 1 1 0\n"                        // mixture
    "f 1 1 1 0 .5 9 0 1\nf 1 1 1 .5 0 9 0 1\n"                       // glossy, diffuse
    "f 1 1 1 0 0 9 1 0\n"                                            // black
    "f 0 0 0 1 0 0 0 0 1 0 1 2 2 2\ns 0 7 0 -.5\nbox 0 0 0 1 1 1\n"  // lights
    "l 1 1 1\nspp 16\n";

}  // namespace

TEST_CASE("a report counts statements, primitives, lights and materials") {
  const SceneReport report = makeReport(load(kScene));
  CHECK(report.statements.at("sphere") == 2);
  CHECK(report.statements.at("polygon") == 1);
  CHECK(report.statements.at("box") == 2);
  CHECK(report.primitives.spheres == 2);
  CHECK(report.primitives.triangles == 2 + 12);
  CHECK(report.primitives.boxes == 1);
  CHECK(report.primitives.cones == 1);
  CHECK(report.primitives.planes == 1);
  CHECK(report.primitives.total() == 19);
  CHECK(report.lights.spheres == 1);
  CHECK(report.lights.triangles == 12);
  CHECK(report.lights.points == 1);
  CHECK(report.lights.total() == 14);
  CHECK(report.materials.diffuse == 3);
  CHECK(report.materials.glossy == 1);
  CHECK(report.materials.mirror == 1);
  CHECK(report.materials.dielectric == 1);
  CHECK(report.materials.mixture == 1);
  CHECK(report.materials.black == 1);
  CHECK(report.materials.emitting == 1);
  CHECK(report.materials.total() == 8);
  CHECK(report.requestedAccel == RequestedAccel::grid);
  CHECK(report.requestedSamples == 16u);
}

TEST_CASE("bounds contain everything but infinite planes, and are exact for cones") {
  const SceneReport report = makeReport(load(kScene));
  REQUIRE(report.bounds);
  CHECK(report.bounds->min == glm::vec3(-4, -2, -2));  // ball, cone's base, box
  CHECK(report.bounds->max == glm::vec3(4, 7.5f, 5));  // quad, light, cone's apex
  CHECK_FALSE(makeReport(load("pl 0 0 0 1 0 0 0 1 0\n")).bounds);
}

TEST_CASE("the memory of a scene is that of its arrays, and per triangle that of meshes") {
  const Scene scene = sceneOf("f 1 1 1 1 0 1 0 1\np 4 0 0 0 4 0 0 4 4 0 0 4 0\ns 0 0 0 1\nl 1 1 1\n");
  const SceneMemory memory = memoryOf(scene);
  CHECK(memory.triangleCount == 2);
  CHECK(memory.triangles == sizeof(Mesh) + 2 * 3 * 12);
  const std::size_t objects = 2 * sizeof(std::uint32_t);  // the starts of the polygon and of the sphere
  CHECK(memory.total ==
        memory.triangles + sizeof(Material) + sizeof(Sphere) + 2 * sizeof(PrimitiveRun) + sizeof(PointLight) + objects);
  CHECK(memory.bytesPerTriangle() == sizeof(Mesh) / 2. + 36);
  CHECK_FALSE(memoryOf(sceneOf("s 0 0 0 1\n")).bytesPerTriangle());
}

TEST_CASE("triangles take no more memory than three positions and a normal index each did") {
  const auto bytesPerTriangle = [](const std::string& statement) {
    std::string text;
    for (int i = 0; i < 1000; ++i) text += statement;
    return *memoryOf(sceneOf(text)).bytesPerTriangle();
  };
  constexpr double kFlat = 40 + 12, kSmooth = kFlat + 36;
  CHECK(bytesPerTriangle("p 3 0 0 0 1 0 0 0 1 0\n") < kFlat);
  CHECK(bytesPerTriangle("p 4 0 0 0 1 0 0 1 1 0 0 1 0\n") < kFlat);
  CHECK(bytesPerTriangle("mesh 4 2 0 0 0 1 0 0 1 1 0 0 1 0 1 2 3 1 3 4\n") < kFlat);
  CHECK(bytesPerTriangle("pp 3 0 0 0 0 0 1 1 0 0 0 0 1 0 1 0 0 0 1\n") < kSmooth);
}

TEST_CASE("the text names statements in words, with their numbers") {
  const std::string text = toText(makeReport(load("l 1 2 3\nl 1 2 3\n")));
  CHECK(text.find("statements  point light 2\n") != std::string::npos);
}

TEST_CASE("JSON holds the same figures under lowerCamel keys") {
  const LoadedScene loaded = load(kScene);
  const nlohmann::json json = toJson(makeReport(loaded));
  CHECK(json["scene"] == "test");
  CHECK(json["statements"]["sphere"] == 2);
  CHECK(json["primitives"]["total"] == 19);
  CHECK(json["bounds"]["min"] == nlohmann::json({-4, -2, -2}));
  CHECK(json["lights"]["triangles"] == 12);
  CHECK(json["materials"]["emitting"] == 1);
  CHECK(json["materials"]["glossy"] == 1);
  CHECK(json["camera"]["size"] == "64x32");
  CHECK(json["camera"]["from"] == nlohmann::json({0, 0, 9}));
  CHECK(json["requestedSamplesPerPixel"] == 16);
  CHECK(json["skySide"].is_null());
  CHECK(json["memory"]["sceneBytes"] == memoryOf(loaded.scene).total);
  CHECK(json["memory"]["bytesPerTriangle"] == *memoryOf(loaded.scene).bytesPerTriangle());
  CHECK(json["warnings"].size() == loaded.warnings.size());
  CHECK(json["sceneHash"].get<std::string>().size() == 16);
  CHECK(json["requestedAccel"] == "grid");
  CHECK(json["requestedMaxDepth"].is_null());
  CHECK(json["requestedFilter"].is_null());
  CHECK(json["requestedCrop"].is_null());
  LoadedScene requesting = load(kScene);
  requesting.scene.requestedMaxDepth = 7;
  requesting.scene.requestedFilter = PixelFilter{FilterKind::tent};
  requesting.scene.requestedCrop = Window{1, 2, 30, 4};
  const SceneReport requests = makeReport(requesting);
  CHECK(toJson(requests)["requestedMaxDepth"] == 7);
  CHECK(toJson(requests)["requestedFilter"] == "tent");
  CHECK(toJson(requests)["requestedCrop"] == "1,2,30,4");
  CHECK(toText(requests).find(
            "  max depth   7 requested\n  filter      tent requested\n  crop        1,2,30,4 requested\n") !=
        std::string::npos);
  CHECK(json["camera"]["shift"] == nlohmann::json({0, 0}));
  CHECK(toText(makeReport(loaded)).find("shift") == std::string::npos);
  CHECK(json["camera"]["mirrored"] == false);
  requesting.scene.camera->isMirrored = true;
  requesting.scene.camera->shift = {0.5f, -0.25f};
  CHECK(toJson(makeReport(requesting))["camera"]["shift"] == nlohmann::json({0.5, -0.25}));
  CHECK(toJson(makeReport(requesting))["camera"]["mirrored"] == true);
  CHECK(toText(makeReport(requesting)).find(", shift 0.5 -0.25, mirrored\n") != std::string::npos);
  const nlohmann::json bare = toJson(makeReport(load("pl 0 0 0 1 0 0 0 1 0\n")));
  CHECK(bare["requestedAccel"].is_null());
  CHECK(bare["camera"].is_null());
  CHECK(bare["bounds"].is_null());
  CHECK(bare["memory"]["bytesPerTriangle"].is_null());
}

TEST_CASE("the text names the figures of the scene") {
  const std::string text = toText(makeReport(load(kScene)));
  for (const char* part : {"test\n", "19: spheres 2, triangles 14", "-4 -2 -2 to 4 7.5 5", "64 x 32", "16 requested",
                           "warning     test:", "bytes per triangle", "background  0.1 0.2 0.3"}) {
    CAPTURE(part);
    CHECK(contains(text, part));
  }
}

TEST_CASE("the hash is FNV-1a of the file's bytes") {
  CHECK(load("").scene.hash == 0xcbf29ce484222325ull);
  CHECK(load("\n").scene.hash == (0xcbf29ce484222325ull ^ 0x0a) * 0x100000001b3ull);
  CHECK(load("b 1 1 1\n").scene.hash != load("b 1 1 1 \n").scene.hash);
}

}  // namespace candela::scene
