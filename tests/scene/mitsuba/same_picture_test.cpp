// Scenes of Mitsuba that have the same film, bit for bit, as the same scene in NFF or glTF.
#include <catch2/catch.hpp>

#include "tests/scene/mitsuba/mitsuba_scenes.h"

namespace candela::mitsuba {
namespace {

using scene::FilterKind;
using scene::PixelFilter;

/// Settings that the Mitsuba scenes request, and others do not.
struct Request {
  std::uint32_t samples = 4;
  std::uint32_t depth = 4;
  PixelFilter filter{FilterKind::box};
  std::optional<render::Window> crop{};
  std::optional<render::Extent> size{};  ///< of the whole picture; absent: that of the film
};

image::Film filmOf(const std::string& file, const Request& request, const render::Extent& filmSize) {
  const scene::Scene scene = sceneNamed(file);
  render::RenderRequest complete;
  complete.sampleCount = request.samples;
  complete.maxDepth = request.depth;
  complete.filter = request.filter;
  complete.size = request.size.value_or(filmSize);
  complete.crop = request.crop;
  return render(scene, render::resolve(complete, scene));
}

void checkSame(const std::string& mitsuba, const std::string& other, const Request& request = {},
               const Reading& reading = {}) {
  INFO(mitsuba << ' ' << reading.camera);
  const image::Film film = pictureOf(mitsuba, reading);
  CHECK(film.hash() == filmOf(other, request, {film.width(), film.height()}).hash());
}

}  // namespace

TEST_CASE("Parameters, included files, references and aliases of Mitsuba give the scene that NFF states") {
  checkSame("structure.xml", "structure.nff");
}

TEST_CASE("Transforms of Mitsuba give the scene that NFF states") { checkSame("transforms.xml", "transforms.nff"); }

TEST_CASE("Meshes of every file format, and cubes, give the scene that NFF states") {
  checkSame("mesh_files.xml", "mesh_files.nff");
}

TEST_CASE("Instances of Mitsuba give the scene that NFF states") { checkSame("instances.xml", "instances.nff"); }

TEST_CASE("Lights of Mitsuba give the scene that glTF states") {
  checkSame("punctual_lights.xml", "punctual_lights.gltf", {16, 3});
}

TEST_CASE("Principled surfaces of Mitsuba give the scene that glTF states") {
  checkSame("surfaces.xml", "surfaces.gltf", {16, 3});
}

TEST_CASE("Every axis of a field of view gives the view that NFF states") {
  for (const char* const camera : {"y", "x", "the default", "diagonal", "smaller", "larger", "focal length"})
    checkSame("sensors.xml", "sensors.nff", {}, {camera});
  checkSame("sensors.xml", "upright_sensors.nff", {}, {"smaller, upright"});
  checkSame("sensors.xml", "upright_sensors.nff", {}, {"larger, upright"});
  checkSame("sensors.xml", "lens.nff", {}, {"lens"});
}

TEST_CASE("Films, filters, samplers and integrators of Mitsuba request their settings") {
  checkSame("film.xml", "sensors.nff", {4, 3, {FilterKind::tent}});
  checkSame("film.xml", "sensors.nff", {6, 2, {FilterKind::box}}, {{}, {"filter=box", "spp=6", "depth=2"}});
  checkSame("film.xml", "sensors.nff", {4, 3, {FilterKind::gaussian, 0.7f}},
            {{}, {"filter=gaussian", "deviation=0.7"}});
  checkSame("film.xml", "sensors.nff", {4, 2, {FilterKind::tent}}, {{}, {"integrator=direct"}});
  checkSame("film.xml", "sensors.nff", {4, 3, {FilterKind::tent}}, {{}, {"integrator=volpath"}});
  checkSame("film.xml", "sensors.nff", {4, 3, {FilterKind::tent}}, {{}, {"integrator=ptracer"}});
  CHECK(pictureOf("film.xml", {{}, {"width=20"}}).width() == 20);
  checkSame("film.xml", "sensors.nff", {4, 3, {FilterKind::tent}, render::Window{9, 5, 14, 11}, render::Extent{32, 24}},
            {"window"});
}

}  // namespace candela::mitsuba
