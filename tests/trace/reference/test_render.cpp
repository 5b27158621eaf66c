// Whole renders by the reference: equality of bytes, statistics, records, interruption.
#include <atomic>
#include <catch2/catch.hpp>
#include <chrono>
#include <set>
#include <thread>
#include <vector>

#include "tests/trace/reference/scene_builder.h"

using namespace candela;
using namespace candela::test;

namespace {

// A camera over a diffuse floor that is reflected in a mirror; a light above, with an occluder on one side of it.
SceneBuilder mirroredFloor() {
  SceneBuilder b;
  b.material(mirrorMaterial(vec3(1))).plane({0, 0, -5}, {1, 0, -5}, {0, 1, -5});
  b.material(diffuseMaterial(vec3(0.5f))).quad({-9, -9, 5}, {9, -9, 5}, {9, 9, 5}, {-9, 9, 5});
  b.pointLight({0, 0, 0}, vec3(1));
  return b.view({0, 0, 1}, {0, 0, -5}, {0, 1, 0}, 1e-3f);
}

render::PathRecord recordOf(const scene::Scene& scene, std::uint32_t maxDepth) {
  render::RenderSettings settings = settingsOf(1, 1, 1);
  settings.execution.recordPaths = true;
  settings.image.maxDepth = maxDepth;
  return renderScene(scene, settings).paths.at(0);
}

/// Returns the luminances and deviations that the replicas of a session find.
std::vector<double> replicaValues(render::Session& session) {
  session.advance({0, 1}, {});
  render::ReplicaSource* const source = session.replicaSource();
  if (source == nullptr) throw std::logic_error("the session traces no replicas");
  const render::ReplicaRecords records = source->replicas();
  std::vector<double> values;
  for (const render::Replica& replica : records.replicas) values.push_back(replica.radiance.x);
  for (const render::Deviation& deviation : records.deviations) values.push_back(deviation.magnitude.x);
  return values;
}

}  // namespace

TEST_CASE("replicas of a session whose camera has moved are those of a session prepared with this camera") {
  SceneBuilder b;
  b.material(diffuseMaterial(vec3(0.5f)));
  for (int i = 0; i < 40; ++i)
    b.sphere({0.5f * static_cast<float>(i % 8) - 2, 0.5f * static_cast<float>(i / 8), 0}, 0.3f);
  b.material(diffuseMaterial(vec3(0), vec3(4))).sphere({0, 6, 3}, 1);
  scene::Scene scene = b.view({0, 1, 5}, {0, 1, 0}, {0, 1, 0}, 60).scene;
  render::RenderSettings settings = settingsOf(8, 8, 1);
  settings.execution.replicas = 2;
  const auto session = reference::makeReferenceRenderer()->prepare(scene, settings);
  const std::vector<double> before = replicaValues(*session);

  scene::Scene moved = scene;
  moved.camera->from = {300, 1, 900};
  moved.camera->angle = 0.4f;
  session->setCamera(*moved.camera);
  const std::vector<double> after = replicaValues(*session);
  CHECK(after == replicaValues(*reference::makeReferenceRenderer()->prepare(moved, settings)));
  CHECK(after != before);
}

TEST_CASE("threads, tiles and the structure do not change a byte of the film") {
  scene::Scene scene = cornellBox().scene;
  for (int i = 0; i < 40; ++i) {  // enough for a BVH
    scene.spheres.push_back({vec3(-0.9f + 0.045f * static_cast<float>(i), -0.95f, 0.3f), 0.04f});
    scene.primitives.push_back({scene::PrimitiveKind::sphere, static_cast<std::uint32_t>(scene.spheres.size() - 1), 1});
  }
  render::RenderSettings settings = settingsOf(24, 17, 4);
  settings.execution.threads = 1;
  const render::RenderResult first = renderScene(scene, settings);
  const std::uint64_t hash = first.film.hash();
  CHECK(first.statistics.structure == render::AccelKind::bvh);
  CHECK(first.statistics.bvhSplit == render::SplitInUse::median);

  settings.execution.threads = 2;
  CHECK(renderScene(scene, settings).film.hash() == hash);
  settings.execution.threads = 7;
  settings.execution.tile = render::Extent{5, 3};
  CHECK(renderScene(scene, settings).film.hash() == hash);
  settings.structure.accel = render::AccelKind::none;
  const render::RenderResult brute = renderScene(scene, settings);
  CHECK(brute.statistics.structure == render::AccelKind::none);
  CHECK(brute.film.hash() == hash);
  settings.structure.accel = render::AccelKind::bvh;
  settings.structure.bvhSplit = render::BvhSplit::midpoint;
  const render::RenderResult midpoint = renderScene(scene, settings);
  CHECK(midpoint.statistics.structure == render::AccelKind::bvh);
  CHECK(midpoint.statistics.bvhSplit == render::SplitInUse::midpoint);
  CHECK(midpoint.film.hash() == hash);
  settings.structure.accel = render::AccelKind::grid;
  const render::RenderResult grid = renderScene(scene, settings);
  CHECK(grid.statistics.structure == render::AccelKind::grid);
  CHECK(grid.film.hash() == hash);
  CHECK(std::set{first.statistics.traversalSteps, brute.statistics.traversalSteps, midpoint.statistics.traversalSteps,
                 grid.statistics.traversalSteps}
            .size() == 4);
  settings.image.seed = 1;
  CHECK(renderScene(scene, settings).film.hash() != hash);
}

TEST_CASE("a lens of aperture 0 is a pinhole, bit for bit") {
  scene::Scene scene = cornellBox().scene;
  render::RenderSettings settings = settingsOf(16, 16, 4);
  const std::uint64_t pinhole = renderScene(scene, settings).film.hash();
  scene.camera->focal = 0.3f;
  CHECK(renderScene(scene, settings).film.hash() == pinhole);
  settings.image.lens = render::LensKind::square;
  CHECK(renderScene(scene, settings).film.hash() == pinhole);
  scene.camera->aperture = 1;
  CHECK(renderScene(scene, settings).film.hash() != pinhole);
}

TEST_CASE("sampler, filter, lens and --one-sided each change the film") {
  scene::Scene scene = cornellBox().scene;
  scene.camera->aperture = 4;
  render::RenderSettings settings = settingsOf(16, 16, 4);
  std::vector<std::uint64_t> hashes{renderScene(scene, settings).film.hash()};
  const auto add = [&](auto change) {
    render::RenderSettings changed = settings;
    change(changed);
    hashes.push_back(renderScene(scene, changed).film.hash());
  };
  add([](render::RenderSettings& s) { s.image.sampler = render::SamplerKind::independent; });
  add([](render::RenderSettings& s) { s.image.sampler = render::SamplerKind::stratified; });
  add([](render::RenderSettings& s) { s.image.filter.kind = render::FilterKind::tent; });
  add([](render::RenderSettings& s) { s.image.lens = render::LensKind::square; });
  add([](render::RenderSettings& s) { s.image.oneSided = true; });
  add([](render::RenderSettings& s) { s.image.nextEventEstimation = false; });
  add([](render::RenderSettings& s) { s.image.rouletteStart = 1; });
  add([](render::RenderSettings& s) { s.image.maxDepth = 3; });
  add([](render::RenderSettings& s) { s.image.pixelOrigin = render::PixelOrigin::corner; });
  std::sort(hashes.begin(), hashes.end());
  CHECK(std::adjacent_find(hashes.begin(), hashes.end()) == hashes.end());
}

TEST_CASE("statistics have the counts of the work that was done") {
  render::RenderSettings settings = settingsOf(7, 5, 3);
  settings.execution.threads = 2;
  const render::RenderStatistics direct = renderScene(mirroredFloor().scene, settings).statistics;
  CHECK(direct.device == "cpu");
  CHECK(direct.kernel == render::KernelInUse::reference);
  CHECK(direct.structure == render::AccelKind::none);
  CHECK(direct.threads == 2);
  CHECK(direct.samples == 105);
  CHECK(direct.cameraRays == 105);
  CHECK(direct.seconds.count("build") == 1);
  CHECK(direct.seconds.count("trace") == 1);
  CHECK(direct.badSamples == 0);

  settings.image.maxDepth = 2;  // mirror, floor, no light sample at the last vertex
  const render::RenderStatistics two = renderScene(mirroredFloor().scene, settings).statistics;
  CHECK(two.bounceRays == 105);
  CHECK(two.vertices == 210);
  CHECK(two.shadowRays == 0);
  CHECK(two.traversalSteps == 210 * 3);
  settings.image.maxDepth = 3;
  const render::RenderStatistics three = renderScene(mirroredFloor().scene, settings).statistics;
  CHECK(three.bounceRays == 210);
  CHECK(three.shadowRays == 105);
}

TEST_CASE("samples that are too bright are counted") {
  SceneBuilder b;
  b.scene.background = {2e6f, 0, 0};
  CHECK(renderScene(b.scene, settingsOf(2, 2, 3)).statistics.badSamples == 12);
}

TEST_CASE("a record contains the decisions of a path") {
  scene::Scene scene = mirroredFloor().scene;
  const render::PathRecord open = recordOf(scene, 64);
  REQUIRE(open.vertexCount >= 3);
  CHECK(open.vertices[0] == render::VertexRecord{0, render::Lobe::mirror, render::ShadowOutcome::notTraced, true});
  CHECK((open.vertices[1].primitive == 1 || open.vertices[1].primitive == 2));
  CHECK(open.vertices[1].lobe == render::Lobe::diffuse);
  CHECK(open.vertices[1].shadow == render::ShadowOutcome::visible);

  const render::PathRecord cut = recordOf(scene, 2);
  REQUIRE(cut.vertexCount == 2);
  CHECK(cut.vertices[1].lobe == render::Lobe::none);
  CHECK(cut.vertices[1].shadow == render::ShadowOutcome::notTraced);

  SceneBuilder screened = mirroredFloor();
  screened.sphere({0.9f, 0, 3}, 0.8f);  // outside the view, and occludes nothing yet
  CHECK(recordOf(screened.scene, 64).vertices[1].shadow == render::ShadowOutcome::visible);
  screened.scene.pointLights[0].position = {1.8f, 0, 1};
  CHECK(recordOf(screened.scene, 64).vertices[1].shadow == render::ShadowOutcome::occluded);
}

TEST_CASE("a record ends with the miss, or at the vertex at which roulette ended the path") {
  SceneBuilder b;
  const render::PathRecord miss = recordOf(b.scene, 64);
  REQUIRE(miss.vertexCount == 1);
  CHECK(miss.vertices[0] == render::VertexRecord{});

  b.material(mirrorMaterial(vec3(1e-6f))).plane({0, 0, -1}, {1, 0, -1}, {0, 1, -1});
  render::RenderSettings settings = settingsOf(1, 1, 1);
  settings.execution.recordPaths = true;
  settings.image.rouletteStart = 0;
  const render::PathRecord ended = renderScene(b.scene, settings).paths.at(0);
  REQUIRE(ended.vertexCount == 1);
  CHECK(ended.vertices[0] == render::VertexRecord{0, render::Lobe::mirror, render::ShadowOutcome::notTraced, false});
}

TEST_CASE("a record contains the first 32 vertices") {
  SceneBuilder b;
  b.material(mirrorMaterial(vec3(1))).sphere({0, 0, 0}, 3);
  const render::PathRecord record = recordOf(b.scene, 100);
  CHECK(record.vertexCount == render::PathRecord::kRecordedVertices);
  CHECK(record.vertices.back().lobe == render::Lobe::mirror);
}

TEST_CASE("progress is reported up to the end, on the calling thread") {
  std::vector<double> fractions;
  std::uint64_t samples = 0;
  render::RenderControl control;
  control.progress = [&](double fraction, std::uint64_t done) {
    fractions.push_back(fraction);
    samples = done;
  };
  render::RenderSettings settings = settingsOf(40, 40, 2);
  settings.execution.threads = 1;
  reference::makeReferenceRenderer()->render(cornellBox().scene, settings, control);
  REQUIRE(fractions.size() == 9);
  CHECK(std::is_sorted(fractions.begin(), fractions.end()));
  CHECK(fractions.back() == 1);
  CHECK(samples == 3200);
}

TEST_CASE("a stopped render reports it and returns the samples rendered so far") {
  std::atomic<bool> stop = false;
  render::RenderControl control;
  control.stop = &stop;
  control.progress = [&](double, std::uint64_t) { stop = true; };
  render::RenderSettings settings = settingsOf(64, 64, 2);
  settings.execution.threads = 2;
  const render::RenderResult result = reference::makeReferenceRenderer()->render(cornellBox().scene, settings, control);
  CHECK(result.interrupted);
  CHECK(result.statistics.samples >= 512);
  CHECK(result.statistics.samples < 64 * 64 * 2);
  std::uint64_t inFilm = 0;
  for (const image::FilmPixel& pixel : result.film.pixels()) inFilm += pixel.sampleCount;
  CHECK(inFilm == result.statistics.samples);

  stop = false;
  control.progress = {};
  CHECK_FALSE(reference::makeReferenceRenderer()->render(cornellBox().scene, settings, control).interrupted);
}

TEST_CASE("a render stops within a pixel, however many samples it has") {
  std::atomic<bool> stop = false;
  const render::RenderSettings settings = settingsOf(1, 1, 2'000'000'000);  // minutes
  const std::jthread stopper([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    stop = true;
  });
  const auto result = reference::makeReferenceRenderer()->render(cornellBox().scene, settings, {&stop, {}});
  CHECK(result.interrupted);
  CHECK(result.film.at(0, 0).sampleCount == result.statistics.samples);
  CHECK(result.statistics.samples < settings.image.sampleCount);
}

TEST_CASE("an exception of a progress callback ends the render") {
  render::RenderControl control;
  control.progress = [](double, std::uint64_t) { throw std::runtime_error("enough"); };
  render::RenderSettings settings = settingsOf(64, 64, 1);
  settings.execution.threads = 2;
  CHECK_THROWS_WITH(reference::makeReferenceRenderer()->render(cornellBox().scene, settings, control), "enough");
}

TEST_CASE("a scene of many primitives that prefers no structure gets none, and a sentence about the cost") {
  SceneBuilder builder;
  builder.material(diffuseMaterial(vec3(0.5f)));
  for (int i = 0; i < 9999; ++i) builder.sphere({0, 0, -5}, 1);
  render::RenderSettings settings = settingsOf(1, 1, 1);
  settings.structure.accel = render::AccelKind::none;
  settings.structure.accelIsPreference = true;
  CHECK(renderScene(builder.scene, settings).statistics.warnings.empty());
  builder.sphere({0, 0, -5}, 1);
  const render::RenderStatistics statistics = renderScene(builder.scene, settings).statistics;
  CHECK(statistics.structure == render::AccelKind::none);
  REQUIRE(statistics.warnings.size() == 1);
  CHECK(statistics.warnings.front().find("every ray tests 10000 primitives: accel = bvh") != std::string::npos);
  settings.structure.accelIsPreference = false;
  CHECK(renderScene(builder.scene, settings).statistics.warnings.empty());
}
