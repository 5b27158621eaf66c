// The street: its lights face it, and pictures on signs can be read.
#include <catch2/catch.hpp>

#include "host/scene/generate/lit_signs.h"
#include "host/scene/generate/street_builder.h"
#include "tests/scene/generate/emitters.h"
#include "tests/scene/generate/generated_text.h"

namespace candela {
namespace {

using generate::StreetPart;
using glm::dvec3;

}  // namespace

TEST_CASE("the front of every emitter of the street is visible, and faces the street or what is below it") {
  const scene::Scene scene = generatedScene("street", 601).scene;
  for (const Emitter& emitter : emittersOf(scene)) {
    CAPTURE(emitter.centre.x, emitter.centre.y, emitter.centre.z);
    const bool isWindow = std::abs(emitter.centre.x) > 7;
    if (isWindow) {
      REQUIRE(emitter.normal.x * emitter.centre.x < -7);
    } else {
      REQUIRE((emitter.normal.y < -0.999 || std::abs(emitter.normal.z) > 0.999));
    }
    for (const dvec3& point : pointsBefore(scene, emitter)) {
      REQUIRE_FALSE(isObstructed(scene, point, point + 0.5 * emitter.normal));
    }
  }
}

TEST_CASE("the street's triangles are counter-clockwise from the side of their normals") {
  generate::StreetBuilder street(300);
  street.addRoad(0, 2);
  street.addPlot(0);
  street.addPlot(1);
  for (const generate::TriangleMesh& mesh : street.meshes()) {
    REQUIRE(mesh.normals.size() == mesh.positions.size());
    CHECK((mesh.texCoords.empty() || mesh.texCoords.size() == mesh.positions.size()));
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
      const std::uint32_t* corner = &mesh.indices[i];
      const glm::vec3 &a = mesh.positions[corner[0]], &b = mesh.positions[corner[1]], &c = mesh.positions[corner[2]];
      REQUIRE(dot(normalize(cross(b - a, c - a)), mesh.normals[corner[0]]) > 0.999f);
    }
  }
}

TEST_CASE("pictures on signs are upright and not mirrored, seen from their front") {
  generate::StreetBuilder street(10'000);
  for (std::uint32_t plot = 0; plot < 30; ++plot) street.addPlot(plot);
  for (std::size_t part = StreetPart::sign; part < StreetPart::count; ++part) {
    const generate::TriangleMesh& mesh = street.meshes()[part];
    REQUIRE(!mesh.texCoords.empty());
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
      const std::uint32_t* corner = &mesh.indices[i];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t from = corner[k], to = corner[(k + 1) % 3];
        const glm::vec2 step = mesh.texCoords[to] - mesh.texCoords[from];
        const dvec3 way = dvec3(mesh.positions[to] - mesh.positions[from]);
        const dvec3 right = cross(dvec3(0, 1, 0), dvec3(mesh.normals[from]));
        CHECK(way.y * -step.y >= 0);
        CHECK(dot(way, right) * step.x >= 0);
      }
    }
  }
}

TEST_CASE("pictures on signs differ, and have bright letters on a dark ground") {
  const std::vector<generate::SignPicture> pictures = generate::signPictures();
  REQUIRE(pictures.size() == generate::kSignCount);
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const generate::SignPicture& picture = pictures[i];
    REQUIRE(picture.rgb.size() == std::size_t{3} * picture.kWidth * picture.kHeight);
    std::size_t bright = 0;
    for (const std::byte value : picture.rgb) bright += std::to_integer<int>(value) > 150 ? 1 : 0;
    CHECK(bright > picture.rgb.size() / 10);
    CHECK(bright < picture.rgb.size() / 2);
    for (std::size_t other = 0; other < i; ++other) CHECK(picture.rgb != pictures[other].rgb);
  }
}

TEST_CASE("signs emit by their pictures, and give light to the street") {
  const scene::LoadedScene loaded = generatedScene("street", 2000);
  std::size_t textured = 0;
  for (const Emitter& emitter : emittersOf(loaded.scene)) {
    const scene::Primitive primitive = loaded.scene.primitives[emitter.primitive];
    const scene::Material& material = loaded.scene.materials[primitive.material];
    if (textureOf(material, scene::TextureSlot::emission)) ++textured;
  }
  CHECK(textured == 4 * 8);  // four triangles in each of eight plots
}

}  // namespace candela
