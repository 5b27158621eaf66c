// Sessions whose camera moves or whose picture changes its size.
#include <catch2/catch.hpp>

#include "host/base/errors.h"
#include "tests/trace/render/session_support.h"

using namespace candela;
using namespace candela::device;

namespace {

scene::Camera movedCamera(const scene::Scene& scene) {
  scene::Camera camera = *scene.camera;
  camera.from += glm::vec3(0.25f, -0.125f, 0.5f);
  camera.at += glm::vec3(0.125f, 0.25f, 0);
  camera.angle *= 0.9f;
  return camera;
}

// The film after a move equals that of a session prepared with the camera, and that of before after moving back.
void requireMovable(render::Renderer& renderer, const scene::Scene& scene, const scene::Camera& camera,
                    const render::RenderSettings& settings) {
  scene::Scene moved = scene;
  moved.camera = camera;
  const render::SampleRange all{0, settings.image.sampleCount};
  const std::uint64_t before = renderer.render(scene, settings, {}).film.hash();
  const std::uint64_t after = renderer.render(moved, settings, {}).film.hash();
  CHECK(before != after);
  const std::unique_ptr<render::Session> session = renderer.prepare(scene, settings);
  CHECK(session->advance(all, {}));
  session->setCamera(camera);
  CHECK(session->advance(all, {}));
  CHECK(session->film().hash() == after);
  session->setCamera(*scene.camera);
  CHECK(session->advance(all, {}));
  CHECK(session->film().hash() == before);
}

}  // namespace

TEST_CASE("moving the camera gives the film of a session prepared with the new camera", "[swiftshader-slow]") {
  onAllRenderers([&](render::Renderer& renderer) {
    for (const char* const name : {"smallpt.p3f", "balls.p3f", "primitives.p3f"}) {
      INFO(name);
      const scene::Scene scene = loadTestScene(name);
      requireMovable(renderer, scene, movedCamera(scene), sessionSettings());
    }
  });
}

TEST_CASE("moving the camera may add or remove its lens, and shift the view", "[swiftshader-slow]") {
  const scene::Scene scene = loadTestScene("cornell.p3f");
  scene::Camera lens = *scene.camera;
  lens.aperture = 10;
  lens.focal = 0.8f;
  lens.shift = {0.25f, -0.125f};
  onAllRenderers([&](render::Renderer& renderer) { requireMovable(renderer, scene, lens, sessionSettings()); });
}

TEST_CASE("moving the camera may make its rays parallel, mirror the view, and back", "[swiftshader-slow]") {
  const scene::Scene scene = loadTestScene("balls.p3f");
  scene::Camera parallel = *scene.camera;
  parallel.orthographicHeight = 5.0f;
  parallel.isMirrored = true;
  scene::Scene begun = scene;
  begun.camera = parallel;
  render::RenderSettings wavefront = sessionSettings();
  wavefront.execution.kernel = render::KernelKind::wavefront;
  onAllRenderers([&](render::Renderer& renderer) {
    requireMovable(renderer, scene, parallel, sessionSettings());
    requireMovable(renderer, begun, *scene.camera, wavefront);
  });
}

TEST_CASE("square lights and ambient occlusion follow the camera", "[swiftshader-slow]") {
  const scene::Scene scene = primitivesUnderLights();
  render::RenderSettings whitted = sessionSettings();
  whitted.image.integrator = render::Integrator::whitted;
  whitted.image.lightSize = 0.5f;
  render::RenderSettings occlusion = sessionSettings();
  occlusion.image.integrator = render::Integrator::ao;
  onAllRenderers([&](render::Renderer& renderer) {
    requireMovable(renderer, scene, movedCamera(scene), whitted);
    requireMovable(renderer, scene, movedCamera(scene), occlusion);
  });
}

TEST_CASE("a film after a change of the view equals that of a session prepared with it", "[swiftshader-slow]") {
  const scene::Scene scene = loadTestScene("primitives.p3f");
  onAllRenderers([&](render::Renderer& renderer) {
    const render::RenderSettings settings = sessionSettings();
    const render::SampleRange all{0, settings.image.sampleCount};
    const std::unique_ptr<render::Session> session = renderer.prepare(scene, settings);
    CHECK(session->advance({0, 3}, {}));
    for (const render::Extent size : {render::Extent{11, 7}, {40, 40}, {64, 33}, {5, 50}}) {
      scene::Scene moved = scene;
      moved.camera = movedCamera(scene);
      render::RenderSettings expected = settings;
      expected.image.size = size;
      session->setView(*moved.camera, size);
      CHECK(session->advance(all, {}));
      const image::Film film = session->film();
      CHECK(film.width() == size.width);
      CHECK(film.hash() == renderer.render(moved, expected, {}).film.hash());
    }
  });
}

TEST_CASE("a session that renders a crop refuses another view") {
  const scene::Scene scene = loadTestScene("primitives.p3f");
  onAllRenderers([&](render::Renderer& renderer) {
    render::RenderSettings settings = sessionSettings();
    settings.image.crop = render::Window{1, 2, 3, 4};
    const std::unique_ptr<render::Session> session = renderer.prepare(scene, settings);
    CHECK_THROWS_AS(session->setView(*scene.camera, {8, 8}), UsageError);
  });
}
