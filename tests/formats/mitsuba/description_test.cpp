// Mitsuba's parameters, references, includes, transforms, and the names of Mitsuba 0.6.
#include "tests/base/temporary_folder.h"
#include "tests/formats/mitsuba/mitsuba_file.h"

namespace candela::mitsuba {
namespace {

/// The image of the origin.
glm::vec3 centreWith(const std::string& operations) {
  return xmlSceneOf("<emitter type=\"point\"><transform name=\"to_world\">" + operations + "</transform></emitter>")
      .punctualLights.at(0)
      .position;
}

}  // namespace

TEST_CASE("Parameters of Mitsuba have the value of the command line, else their default") {
  const std::string content = R"(<default name="r" value="2"/><default name="rough" value="7"/>
<default name="r" value="9"/><default name="twice" value="$r$r"/>
<shape type="sphere"><float name="radius" value="$r"/></shape>
<shape type="sphere"><float name="radius" value="$rough"/></shape>
<shape type="sphere"><float name="radius" value="$twice"/></shape>)";
  const auto radii = [&](const scene::LoadOptions& options) {
    std::vector<float> result;
    for (const scene::Sphere& sphere : loadXml(content, options).scene.spheres) result.push_back(sphere.radius);
    return result;
  };
  CHECK(radii({}) == std::vector<float>{2, 7, 22});
  CHECK(radii({.definitions = {"r=3", "rough=0.5"}}) == std::vector<float>{3, 0.5f, 33});
  CHECK(loadXml(content).scene.hash != loadXml(content, {.definitions = {"r=3"}}).scene.hash);
  CHECK(xmlErrorsOf(content, {.definitions = {"s=3"}}) ==
        "test.xml:1:1: no attribute contains $s, which define = s=... defines");
  CHECK(xmlErrorsOf(content, {.definitions = {"r"}}).find("a definition is NAME=VALUE") != std::string::npos);
  CHECK(xmlErrorsOf("<shape type=\"$kind\"/>").find("2:1: the parameter \"kind\" has no value") != std::string::npos);
  CHECK(xmlSceneOf(R"(<shape type="sphere" id="\$a"/>)").objectNames == std::vector<std::string>{"$a"});
}

TEST_CASE("Objects of Mitsuba refer to others before and after them") {
  const scene::Scene scene = xmlSceneOf(R"(<shape type="sphere"><ref id="red"/></shape>
<bsdf type="diffuse" id="red"><rgb name="reflectance" value="1 0 0"/></bsdf>
<alias id="red" as="rot"/><shape type="sphere"><ref name="bsdf" id="rot"/></shape><shape type="sphere"/>)");
  REQUIRE(scene.primitives.size() == 3);
  CHECK(frontOf(scene, 0).diffuse->colour == glm::vec3(1, 0, 0));
  CHECK(frontOf(scene, 2).diffuse->colour == glm::vec3(0.5f));
  CHECK(scene.primitives[1].material == scene.primitives[0].material);
  CHECK(scene.materialNames[0] == "red");
}

TEST_CASE("Operations of a transform are applied in their order") {
  CHECK(centreWith(R"(<translate x="1"/><scale value="2"/>)") == glm::vec3(2, 0, 0));
  CHECK(centreWith(R"(<scale value="2"/><translate x="1"/>)") == glm::vec3(1, 0, 0));
  CHECK(centreWith(R"(<translate value="1, 2, 3"/><rotate z="1" angle="90"/>)") == glm::vec3(-2, 1, 3));
  CHECK(centreWith(R"(<translate x="1"/><rotate y="1" angle="-90"/>)") == glm::vec3(0, 0, 1));
  CHECK(near(centreWith(R"(<translate x="1"/><rotate value="1 1 1" angle="120"/>)"), {0, 1, 0}));
  CHECK(centreWith(R"(<translate x="1" y="1" z="1"/><matrix value="1 2 3 4 0 1 0 5 0 0 1 6 0 0 0 1"/>)") ==
        glm::vec3(10, 6, 7));
  CHECK(centreWith(R"(<translate x="1" y="1" z="1"/><matrix value="0 1 0 0 0 1 2 0 0"/>)").x == 1);
  CHECK(near(centreWith(R"(<translate z="2"/><lookat origin="1, 0, 0" target="1, 5, 0" up="0, 0, 1"/>)"), {1, 2, 0}));
  CHECK(near(centreWith(R"(<translate x="2"/><lookat origin="0 0 0" target="0 1 0" up="0 0 1"/>)"), {-2, 0, 0}));
}

TEST_CASE("Files of Mitsuba include others, which find their files in their own folder or the scene's") {
  const TemporaryFolder folder;
  folder.write("ball.xml", R"(<shape version="3.0.0" type="sphere"><float name="radius" value="$r"/></shape>)");
  folder.write("part.xml",
               "<scene version=\"0.6.0\"><default name=\"r\" value=\"4\"/><include filename=\"ball.xml\"/>"
               "<shape type=\"sphere\"><transform name=\"toWorld\"><scale value=\"3\"/></transform></shape>"
               "</scene>");
  const scene::LoadedScene loaded = loadXml("<include filename=\"part.xml\"/>", {}, "3.0.0", folder.path(""));
  REQUIRE(loaded.scene.spheres.size() == 2);
  CHECK(loaded.scene.spheres[0].radius == 4);
  CHECK(loaded.scene.spheres[1].radius == 3);
  CHECK(loaded.files.size() == 2);
  folder.write("loop.xml", "<scene version=\"3.0.0\"><include filename=\"loop.xml\"/></scene>");
  CHECK(xmlErrorsOf("<include filename=\"loop.xml\"/>", {}, "3.0.0", folder.path("")).find("more than 15 deep") !=
        std::string::npos);
  CHECK(xmlErrorsOf("<include filename=\"/etc/passwd\"/>", {}, "3.0.0", folder.path(""))
            .find("2:1: \"/etc/passwd\" is outside the scene's folder") != std::string::npos);
  folder.write("wrong.xml", "<scene version=\"3.0.0\">\n<shape type=\"spere\"/></scene>");
  const std::string errors = xmlErrorsOf("<include filename=\"wrong.xml\"/>", {}, "3.0.0", folder.path(""));
  CHECK(errors.find("wrong.xml:2:1: unknown shape \"spere\"; did you mean \"sphere\"?") != std::string::npos);
}

TEST_CASE("Names of Mitsuba 0.6 have their meaning in files of its version alone") {
  const std::string content = R"(<shape type="sphere"><transform name="toWorld"><scale value="2"/></transform></shape>
<sensor type="perspective"><float name="fov" value="60"/><string name="fovAxis" value="y"/>
<film type="hdrfilm"><integer name="width" value="20"/><integer name="height" value="10"/>
<rfilter type="box"/></film><sampler type="independent"><integer name="sampleCount" value="3"/></sampler></sensor>
<integrator type="path"><integer name="maxDepth" value="5"/></integrator>)";
  const scene::Scene scene = xmlSceneOf(content, "0.6.0");
  CHECK(scene.spheres.at(0).radius == 2);
  CHECK(scene.camera->angle == 60);
  CHECK(scene.requestedSamples == 3u);
  CHECK(scene.requestedMaxDepth == 5u);
  const std::string errors = xmlErrorsOf(content);
  CHECK(errors.find("2:22: shape \"sphere\" has no property \"toWorld\"; did you mean \"to_world\"?") !=
        std::string::npos);
  CHECK(materialOf(R"(<bsdf type="diffuse"><srgb name="reflectance" value="#ff0080"/></bsdf>)", "0.6.0")
            .diffuse->colour.z == Approx(0.2158605));
  CHECK(materialOf(R"(<bsdf type="diffuse"><rgb name="diffuseReflectance" value="0.25"/></bsdf>)", "0.6.0")
            .diffuse->colour == glm::vec3(0.25f));
}

}  // namespace candela::mitsuba
