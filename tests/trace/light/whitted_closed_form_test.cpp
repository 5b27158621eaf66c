// Whitted's pictures whose exact values are known independently of both tracers.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "tests/trace/render/both_tracers.h"

using namespace candela;
using namespace candela::device;

namespace {

render::RenderSettings whittedSettings(std::uint32_t side, std::uint32_t maxDepth) {
  render::RenderSettings settings = squareSettings(side, 1);
  settings.image.integrator = render::Integrator::whitted;
  settings.image.maxDepth = maxDepth;
  return settings;
}

// A narrow view from `from` (x y z) to the origin.
std::string view(const std::string& from) {
  return "v\nfrom " + from + "\nat 0 0 0\nup 0 1 0\nangle 0.001\nhither 0\nresolution 4 4\n";
}

void checkColour(const image::Film& film, const glm::dvec3& expected) {
  const glm::dvec3 mean = film.mean(2, 1);
  CHECK(mean.x == Approx(expected.x).epsilon(1e-4));
  CHECK(mean.y == Approx(expected.y).epsilon(1e-4));
  CHECK(mean.z == Approx(expected.z).epsilon(1e-4));
}

}  // namespace

TEST_CASE("a plane shows diffuse, specular, ambient, emitted and mirrored light") {
  // Seen from above; the light is at the angle of cosine 3/5, so that (N.H)^2 = (1 + 3/5) / 2, and Shine is 10.
  scene::Scene scene = sceneFromText("b 0.1 0.2 0.4\n" + view("0 0 5") +
                                     "l 4 0 3 1 2 3\nf 0.8 0.5 0.25 0.5 0.9 1 0.3 0.25 10 0 1\npl 0 0 0 1 0 0 0 1 0\n");
  scene.materials[0].whitted->ka = 0.125f;
  scene.materials[0].emission = {0.5f, 0, 0.25f};
  const double highlight = std::pow(0.8, 5);
  const glm::dvec3 light(1, 2, 3), diffuse(0.8, 0.5, 0.25), specular(0.9, 1, 0.3);
  const glm::dvec3 expected = light * (0.5 * 0.6 * diffuse + 0.25 * highlight * specular) + 0.125 * diffuse +
                              glm::dvec3(0.5, 0, 0.25) + 0.25 * glm::dvec3(0.1, 0.2, 0.4);
  onBothTracers([&](const RenderFunction& renderScene) {
    const render::RenderResult result = renderScene(scene, whittedSettings(4, 2));
    checkColour(result.film, expected);
    CHECK(result.statistics.treeRays->cameraHits == 16);
    CHECK(result.statistics.treeRays->reflected == 16);
    CHECK(result.statistics.shadowRays == 16);
    const render::RenderResult withoutTree = renderScene(scene, whittedSettings(4, 1));
    CHECK(withoutTree.statistics.bounceRays == 0);
    checkColour(withoutTree.film, expected - 0.25 * glm::dvec3(0.1, 0.2, 0.4));
  });
}

TEST_CASE("a light behind the surface, in its plane or behind an occluder contributes nothing") {
  const auto lightAndRays = GENERATE(
      table<std::string, std::uint64_t>({{"l 1 2 -3\n", 0}, {"l 7 0 0\n", 0}, {"l 1 1 2\n", 16}, {"l 1 1 0.5\n", 16}}));
  const std::string& light = std::get<0>(lightAndRays);
  const std::uint64_t shadowRays = std::get<1>(lightAndRays);
  const bool visible = light == "l 1 1 0.5\n";  // in front of the obstacle at half the distance of the third
  const scene::Scene scene = sceneFromText(view("0 -3 4") + light + "f 1 1 1 1 0 0 0 0 1 0 1\npl 0 0 0 1 0 0 0 1 0\n" +
                                           "f 1 1 1 0 1 1 1 0 1 1 1.5\ns 0.5 0.5 1 0.2\n");
  onBothTracers([&](const RenderFunction& renderScene) {
    const render::RenderResult result = renderScene(scene, whittedSettings(4, 1));
    CAPTURE(light);
    CHECK(result.statistics.shadowRays == shadowRays);
    CHECK((pixelLuminance(result.film, 2, 2) > 0) == visible);
  });
}

TEST_CASE("a mirror shows Ks times the background that it reflects") {
  // The background is blue in every direction; the mirror's own colours do not count.
  const scene::Scene scene = sceneFromText("b 0.1 0.2 0.4\n" + view("1 2 5") +
                                           "f 0.3 0.6 0.9 0.7 0.2 0.4 0.6 0.75 1 0 1\npl 0 0 0 1 0 0 0 1 0\n");
  onBothTracers([&](const RenderFunction& renderScene) {
    checkColour(renderScene(scene, whittedSettings(4, 4)).film, 0.75 * glm::dvec3(0.1, 0.2, 0.4));
  });
}

TEST_CASE("a slab of glass lacks only the contribution of rays beyond the maximum depth, by exact Fresnel") {
  // Every ray that exits sees the background; those of depth 5 that stay inside see nothing.
  const double degrees = GENERATE(0.0, 30.0, 56.3, 75.0);
  const double angle = degrees * std::numbers::pi / 180;
  const double refracted = std::asin(std::sin(angle) / 1.5);
  const double rs = angle == 0 ? 0.2 : std::sin(angle - refracted) / std::sin(angle + refracted);
  const double rp = angle == 0 ? 0.2 : std::tan(angle - refracted) / std::tan(angle + refracted);
  const double r = (rs * rs + rp * rp) / 2;
  scene::Scene scene = sceneFromText("b 0.1 0.2 0.4\n" + view("0 0 1") +
                                     "f 1 1 1 0 1 1 1 0 1 1 1.5\nbox -1000 -1000 -1 1000 1000 0\n");
  scene.camera->from = glm::vec3(5 * std::sin(angle), 0, 5 * std::cos(angle));
  onBothTracers([&](const RenderFunction& renderScene) {
    const render::RenderResult result = renderScene(scene, whittedSettings(4, 5));
    const double seen = r + (1 - r) * (1 - r) * (1 + r + r * r);
    checkColour(result.film, seen * glm::dvec3(0.1, 0.2, 0.4));
    CHECK(result.statistics.treeRays->cameraHits == 16);
    CHECK(result.statistics.treeRays->reflected == 4 * 16);
    CHECK(result.statistics.treeRays->refracted == 4 * 16);
  });
}

TEST_CASE("a ray inside glass beyond the critical angle is reflected totally, and never exits") {
  const scene::Scene scene = sceneFromText(
      "b 1 1 1\nv\nfrom 0.1 0.2 0\nat 1.1 1.2 0\nup 0 0 1\nangle 0.001\nhither 0\nresolution 4 4\n"
      "f 1 1 1 0 1 1 1 0 1 1 1.5\nbox -2 -2 -2 2 2 2\n");
  onBothTracers([&](const RenderFunction& renderScene) {
    const render::RenderResult result = renderScene(scene, whittedSettings(4, 5));
    CHECK(result.statistics.treeRays->reflected == 4 * 16);
    CHECK(result.statistics.treeRays->refracted == 0);
    CHECK(meanLuminance(result.film) == 0);
  });
}

TEST_CASE("a material with T but without an index of refraction shows only its local colour") {
  const scene::Scene scene = sceneFromText("b 1 1 1\n" + view("0 0 5") +
                                           "l 0 0 9\nf 0.5 0.5 0.5 0.5 1 1 1 0.5 1 1 0\npl 0 0 0 1 0 0 0 1 0\n");
  onBothTracers([&](const RenderFunction& renderScene) {
    const render::RenderResult result = renderScene(scene, whittedSettings(4, 4));
    CHECK(result.statistics.bounceRays == 0);
    checkColour(result.film, glm::dvec3(0.25 + 0.5));
  });
}

TEST_CASE("a square light that is half occluded by an edge gives half of its light") {
  // The light is 4 above the origin and faces it; the edge is 2 above, where it hides one half exactly, or far below.
  const std::string floor = "l 0 0 4\nf 0.9 0.9 0.9 1 0 0 0 0 1 0 1\npl 0 0 0 1 0 0 0 1 0\n";
  const scene::Scene open = sceneFromText(view("1 -4 1") + floor + "p 3\n0 -50 -2\n90 0 -2\n0 50 -2\n");
  const scene::Scene cut = sceneFromText(view("1 -4 1") + floor + "p 3\n0 -50 2\n90 0 2\n0 50 2\n");
  onBothTracers([&](const RenderFunction& renderScene) {
    render::RenderSettings settings = whittedSettings(4, 1);
    settings.image.lightSize = 1;
    settings.image.sampleCount = 1024;
    settings.image.sampler = render::SamplerKind::stratified;
    const double whole = pixelLuminance(renderScene(open, settings).film, 1, 1);
    // cos = 4 / sqrt(16 + x^2 + y^2), about 1 - (x^2 + y^2) / 32, with x and y uniform in [-1/2, 1/2].
    CHECK(whole == Approx(0.9 * (1 - (1.0 / 6) / 32)).epsilon(3e-4));
    CHECK(pixelLuminance(renderScene(cut, settings).film, 1, 1) == Approx(whole / 2).epsilon(5e-3));
  });
}
