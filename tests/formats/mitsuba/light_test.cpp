// Emitters, sensors, films and integrators of Mitsuba.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "host/image/image.h"
#include "tests/base/temporary_folder.h"
#include "tests/formats/mitsuba/mitsuba_file.h"

namespace candela::mitsuba {
namespace {

using scene::PunctualLight;

std::string emitter(const std::string& type, const std::string& content) {
  return "<emitter type=\"" + type + "\">" + content + "</emitter>";
}
std::string sensor(const std::string& type, const std::string& content) {
  return "<sensor type=\"" + type + "\">" + content +
         "<film type=\"hdrfilm\"><integer name=\"width\" value=\"40\"/><integer name=\"height\" value=\"20\"/><rfilter "
         "type=\"box\"/></film></sensor>";
}
scene::Camera cameraOf(const std::string& type, const std::string& content) {
  return *xmlSceneOf(sensor(type, content)).camera;
}
const std::string
    kView = R"(<transform name="to_world"><lookat origin="1, 2, 3" target="1, 2, 0" up="0, 1, 0"/></transform>)";

}  // namespace

TEST_CASE("Point, spot and directional lights of Mitsuba are punctual lights") {
  const scene::Scene scene = xmlSceneOf(
      emitter("point", R"(<point name="position" x="1" y="2" z="3"/><rgb name="intensity" value="4 5 6"/>)") +
      emitter("point", R"(<transform name="to_world"><translate x="7"/></transform>)") +
      emitter("directional", R"(<vector name="direction" x="0" y="0" z="-2"/><rgb name="irradiance" value="2"/>)") +
      emitter("spot", R"(<transform name="to_world"><lookat origin="0 3 0" target="0 0 0" up="0 0 1"/></transform>
<float name="cutoff_angle" value="30"/><float name="beam_width" value="30"/>)"));
  REQUIRE(scene.punctualLights.size() == 4);
  CHECK(scene.punctualLights[0].position == glm::vec3(1, 2, 3));
  CHECK(scene.punctualLights[0].intensity == glm::vec3(4, 5, 6));
  CHECK(scene.punctualLights[1].position == glm::vec3(7, 0, 0));
  CHECK(scene.punctualLights[1].intensity == glm::vec3(1));
  CHECK(scene.punctualLights[2].kind == PunctualLight::Kind::directional);
  CHECK(scene.punctualLights[2].direction == glm::vec3(0, 0, -1));
  CHECK(scene.punctualLights[2].intensity == glm::vec3(2));
  const PunctualLight& spot = scene.punctualLights[3];
  CHECK(spot.kind == PunctualLight::Kind::spot);
  CHECK(spot.position == glm::vec3(0, 3, 0));
  CHECK(near(spot.direction, {0, -1, 0}));
  CHECK(spot.versineOuter == Approx(1 - std::cos(std::numbers::pi / 6)));
  CHECK(spot.versineInner < spot.versineOuter);
  CHECK(spot.versineInner > 0.999f * spot.versineOuter);
}

// The power of a spot light of either kind is the integral of its intensity over the sphere.
TEST_CASE("A spot light has the power of Mitsuba's, whose fall-off is another one") {
  const scene::LoadedScene loaded = loadXml(
      emitter("spot", R"(<float name="cutoff_angle" value="60"/><float name="beam_width" value="20"/>)"));
  const PunctualLight& spot = loaded.scene.punctualLights.at(0);
  const double cutoff = std::numbers::pi / 3, beam = std::numbers::pi / 9;
  double mitsuba = 0, gltf = 0;
  constexpr int kSteps = 100000;
  for (int i = 0; i < kSteps; ++i) {
    const double angle = (i + 0.5) / kSteps * cutoff, weight = std::sin(angle) * cutoff / kSteps;
    mitsuba += weight * std::min((cutoff - angle) / (cutoff - beam), 1.0);
    const double a = std::clamp(
        (double{spot.versineOuter} - (1 - std::cos(angle))) / (double{spot.versineOuter} - double{spot.versineInner}),
        0.0, 1.0);
    gltf += weight * a * a;
  }
  CHECK(gltf == Approx(mitsuba).epsilon(1e-5));
  const auto isFallOff = [](const std::string& warning) {
    return warning.find("not rendered: the linear fall-off of emitter \"spot\"") != std::string::npos;
  };
  CHECK(std::ranges::any_of(xmlWarningsOf(loaded), isFallOff));
}

TEST_CASE("The texture of a spot light is an error, or left out with a warning") {
  const std::string spot = emitter("spot", R"(<texture type="checkerboard" name="texture"/>)");
  CHECK(xmlErrorsOf(spot).find("2:22: the texture of a spot light is not rendered; lenient leaves it out") !=
        std::string::npos);
  CHECK(loadXml(spot, {.lenient = true}).scene.punctualLights.size() == 1);
}

// Mitsuba: u = atan2(x, -z) / 2 pi, v = acos(y) / pi. The left edge of the map is -z, a quarter of the width is +x.
TEST_CASE("An environment map has Mitsuba's directions") {
  const TemporaryFolder folder;
  image::Image map;
  map.width = 4;
  map.height = 2;
  map.rgb.assign(8, glm::vec3(1));
  image::writeImage(folder.path("map.pfm"), map, {});
  const auto axesWith = [&](const std::string& content) {
    return loadXml(emitter("envmap",
                           R"(<string name="filename" value="map.pfm"/><float name="scale" value="3"/>)" + content),
                   {}, "3.0.0", folder.path(""))
        .scene.environment;
  };
  const auto environment = axesWith("");
  REQUIRE(environment);
  CHECK(environment->texels[0] == glm::vec3(3));
  const auto columnOf = [](const scene::Environment& sky, const glm::dvec3& d) {
    const double x = glm::dot(d, glm::dvec3(sky.axes[0])), z = glm::dot(d, glm::dvec3(sky.axes[2]));
    const double s = 0.5 + std::atan2(z, x) / (2 * std::numbers::pi);
    return s - std::floor(s);
  };
  for (const glm::dvec3& d :
       {glm::dvec3(1, 0, 0), glm::dvec3(0.6, 0, 0.8), glm::dvec3(-0.6, 0, 0.8), glm::dvec3(-0.8, 0, -0.6)}) {
    const double u = std::atan2(d.x, -d.z) / (2 * std::numbers::pi);
    CHECK(columnOf(*environment, d) == Approx(u - std::floor(u)));
  }
  CHECK(environment->axes[1] == glm::vec3(0, 1, 0));
  const auto turned = axesWith(R"(<transform name="to_world"><rotate x="1" angle="90"/></transform>)");
  CHECK(near(turned->axes[1], {0, 0, 1}));
  CHECK(near(turned->axes[0], {0, -1, 0}));
  CHECK(xmlErrorsOf(emitter("envmap", R"(<string name="filename" value="no.exr"/>)"), {}, "3.0.0", folder.path(""))
            .find("test.xml:2:1: ") == 0);
  CHECK(xmlSceneOf(emitter("constant", R"(<rgb name="radiance" value="1 2 3"/>)")).background == glm::vec3(1, 2, 3));
}

TEST_CASE("A perspective sensor has the vertical angle of every axis of its field of view") {
  const auto angleOf = [](const std::string& axis) {
    return cameraOf("perspective",
                    "<float name=\"fov\" value=\"60\"/><string name=\"fov_axis\" value=\"" + axis + "\"/>" + kView)
        .angle;
  };
  const auto degrees = [](double tangent) { return 2 * std::atan(tangent) * 180 / std::numbers::pi; };
  const double t = std::tan(std::numbers::pi / 6);
  CHECK(angleOf("x") == Approx(degrees(t / 2)));
  CHECK(angleOf("y") == 60);
  CHECK(angleOf("smaller") == 60);
  CHECK(angleOf("larger") == Approx(degrees(t / 2)));
  CHECK(angleOf("diagonal") == Approx(degrees(t / std::sqrt(5.0))));
  CHECK(cameraOf("perspective", R"(<string name="focal_length" value="50mm"/>)" + kView).angle ==
        Approx(degrees(std::sqrt(36.0 * 36 + 24 * 24) / 100 / std::sqrt(5.0))));
  const scene::Camera camera = cameraOf("perspective", "<float name=\"fov\" value=\"60\"/>" + kView);
  CHECK(camera.from == glm::vec3(1, 2, 3));
  CHECK(camera.at == glm::vec3(1, 2, 2));
  CHECK(camera.up == glm::vec3(0, 1, 0));
  CHECK(camera.width == 40);
  CHECK(camera.height == 20);
  CHECK(camera.aperture == 0);
  CHECK(camera.shift == glm::vec2(0));
  CHECK_FALSE(camera.isMirrored);
  CHECK(cameraOf("perspective", R"(<transform name="to_world"><scale x="-1"/></transform>)").isMirrored);
  CHECK(cameraOf("perspective", R"(<float name="principal_point_offset_x" value="0.25"/>
<float name="principal_point_offset_y" value="-0.5"/>)")
            .shift == glm::vec2(0.25f, -0.5f));
}

// The radius of the lens in units of the scene is aperture * h / height, h = 2 d tan(angle/2).
TEST_CASE("A thin lens has Mitsuba's radius and plane of focus") {
  const scene::Camera camera = cameraOf(
      "thinlens",
      R"(<float name="fov" value="60"/><float name="aperture_radius" value="0.5"/><float name="focus_distance" value="8"/>)" +
          kView);
  CHECK(glm::length(glm::dvec3(camera.at - camera.from)) == Approx(8));
  CHECK(camera.focal == 1);
  const double h = 2 * 8 * std::tan(double{camera.angle} * std::numbers::pi / 360);
  CHECK(camera.aperture * h / 20 == Approx(0.5));
}

TEST_CASE("An orthographic sensor shows twice its scale") {
  const scene::Camera camera = cameraOf(
      "orthographic",
      R"(<transform name="to_world"><scale x="3" y="3"/><lookat origin="1, 2, 3" target="1, 2, 0" up="0, 1, 0"/></transform>)");
  REQUIRE(camera.orthographicHeight);
  CHECK(*camera.orthographicHeight == 3);  // the width is 6
  CHECK(camera.from == glm::vec3(1, 2, 3));
}

TEST_CASE("Views that Candela does not have are errors, or replaced with a warning") {
  const scene::LoadOptions lenient{.lenient = true};
  const auto check = [&](const std::string& content, const std::string& message) {
    CAPTURE(content);
    CHECK(xmlErrorsOf(content).find(message) != std::string::npos);
    CHECK_FALSE(loadXml(content, lenient).warnings.empty());
  };
  CHECK(xmlErrorsOf(sensor("orthographic", R"(<float name="principal_point_offset_x" value="0.1"/>)"))
            .find("has no property \"principal_point_offset_x\"") != std::string::npos);
  check(R"(<sensor type="distant"/>)", "sensor \"distant\" is not rendered");
  CHECK(xmlErrorsOf(sensor("perspective", R"(<float name="fov" value="180"/>)")).find("between 0 and 180") !=
        std::string::npos);
}

TEST_CASE("Film, sampler and integrator request the filter, the samples and the depth") {
  const auto withIntegrator = [](const std::string& text) {
    return xmlSceneOf("<integrator type=" + text).requestedMaxDepth;
  };
  CHECK(withIntegrator(R"("path"/>)") == 1024u);
  CHECK(withIntegrator(R"("path"><integer name="max_depth" value="1"/></integrator>)") == 1u);
  CHECK(withIntegrator(
            R"("path"><integer name="max_depth" value="7"/><integer name="rr_depth" value="3"/></integrator>)") == 7u);
  CHECK(withIntegrator(R"("direct"/>)") == 2u);
  CHECK(withIntegrator(
            R"("moment"><integrator type="path"><integer name="max_depth" value="3"/></integrator></integrator>)") ==
        3u);
  CHECK(xmlErrorsOf(R"(<integrator type="path"><integer name="max_depth" value="0"/></integrator>)")
            .find("a picture of depth 0 is black") != std::string::npos);
  CHECK(
      xmlErrorsOf(R"(<integrator type="depth"/>)").find("integrator \"depth\" is not rendered; lenient traces paths") !=
      std::string::npos);
  using scene::FilterKind, scene::PixelFilter;
  const auto filterOf = [](const std::string& filter) {
    return xmlSceneOf(
        "<sensor type=\"perspective\"><film type=\"hdrfilm\">" + filter +
        "</film><sampler type=\"multijitter\"><integer name=\"sample_count\" value=\"9\"/></sampler></sensor>");
  };
  CHECK(filterOf("<rfilter type=\"box\"/>").requestedFilter == PixelFilter{FilterKind::box});
  CHECK(filterOf("<rfilter type=\"tent\"/>").requestedFilter == PixelFilter{FilterKind::tent});
  CHECK(filterOf("<rfilter type=\"gaussian\"/>").requestedFilter == PixelFilter{FilterKind::gaussian, 0.5f});
  CHECK(filterOf("<rfilter type=\"gaussian\"><float name=\"stddev\" value=\"0.7\"/></rfilter>").requestedFilter ==
        PixelFilter{FilterKind::gaussian, 0.7f});
  CHECK(filterOf("").requestedFilter == PixelFilter{FilterKind::gaussian, 0.5f});
  CHECK(filterOf("").requestedSamples == 9u);
  CHECK(filterOf("").camera->width == 768);
}

TEST_CASE("A film requests its window, which must be within it") {
  const auto film = [](const std::string& properties) {
    return R"(<sensor type="perspective"><film type="hdrfilm"><integer name="width" value="40"/><integer name="height" value="30"/>)" +
           properties + "</film></sensor>";
  };
  const auto window = [&](const std::string& x, const std::string& y, const std::string& width,
                          const std::string& height) {
    const auto property = [](const std::string& name, const std::string& value) {
      return "<integer name=\"crop_" + name + "\" value=\"" + value + "\"/>";
    };
    return film(property("offset_x", x) + property("offset_y", y) + property("width", width) +
                property("height", height));
  };
  const scene::Scene scene = xmlSceneOf(window("3", "5", "20", "10"));
  CHECK(scene.requestedCrop == scene::Window{3, 5, 20, 10});
  CHECK(scene.camera->width == 40);
  CHECK(xmlSceneOf(film(R"(<integer name="crop_width" value="7"/>)")).requestedCrop == scene::Window{0, 0, 7, 30});
  CHECK(xmlSceneOf(window("39", "29", "1", "1")).requestedCrop == scene::Window{39, 29, 1, 1});
  CHECK_FALSE(xmlSceneOf(window("0", "0", "40", "30")).requestedCrop);
  CHECK_FALSE(xmlSceneOf(film("")).requestedCrop);
  CHECK(xmlErrorsOf(window("21", "0", "20", "30"))
            .find("2:28: the window 21,0,20,30 (crop_offset_x, ...) is not within "
                  "the film of 40 by 30 pixels") != std::string::npos);
  for (const std::string& wrong :
       {window("0", "21", "40", "10"), window("0", "0", "0", "10"), window("0", "0", "10", "0"),
        window("-1", "0", "10", "10"), window("0", "-1", "10", "10"), window("9223372036854775807", "0", "10", "10"),
        window("0", "0", "41", "10"), window("0", "0", "10", "31"),
        film(R"(<integer name="crop_offset_x" value="1"/>)")})
    CHECK(xmlErrorsOf(wrong).find("is not within the film") != std::string::npos);
}

TEST_CASE("The command line chooses among the sensors of a scene") {
  const std::string content =
      R"(<sensor type="perspective" id="a"><float name="fov" value="30"/><string name="fov_axis" value="y"/></sensor>
<sensor type="perspective" id="b"><float name="fov" value="50"/><string name="fov_axis" value="y"/></sensor>)";
  CHECK(loadXml(content).scene.camera->angle == 30);
  CHECK(loadXml(content, {.camera = "b"}).scene.camera->angle == 50);
  CHECK(loadXml(content, {.camera = "1"}).scene.camera->angle == 50);
  CHECK(loadXml(content, {.camera = "none"}).scene.camera->angle == 30);  // that of the framing view
  CHECK(xmlErrorsOf(content, {.camera = "c"}).find("no sensor has the id or the index \"c\"") != std::string::npos);
}

}  // namespace candela::mitsuba
