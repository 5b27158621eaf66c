// Shapes of Mitsuba as primitives.
#include <zlib.h>

#include <cmath>
#include <numbers>

#include "host/image/colour_transfer.h"
#include "tests/base/temporary_folder.h"
#include "tests/formats/mitsuba/mitsuba_file.h"

namespace candela::mitsuba {
namespace {

const std::string kEmitter = R"(<emitter type="area"><rgb name="radiance" value="3 2 1"/></emitter>)";
const std::string kMasked = R"(<bsdf type="mask"><bsdf type="diffuse"/></bsdf>)";

std::string shape(const std::string& type, const std::string& content = "") {
  return "<shape type=\"" + type + "\">" + content + "</shape>";
}
std::string transform(const std::string& operations) {
  return "<transform name=\"to_world\">" + operations + "</transform>";
}

/// The area of the triangles of a scene with a material, by default that of the first one, and their mean normal.
std::pair<double, glm::dvec3> areaOf(const scene::Scene& scene, std::optional<std::uint32_t> wanted = {}) {
  const std::uint32_t material = wanted.value_or(scene.primitives[0].material);
  double area = 0;
  glm::dvec3 normal(0);
  for (const scene::Primitive& primitive : scene.primitives) {
    if (primitive.material != material) continue;
    const scene::Triangle t = triangleOf(scene, primitive);
    const glm::dvec3 cross = glm::cross(glm::dvec3(t.p[1]) - glm::dvec3(t.p[0]),
                                        glm::dvec3(t.p[2]) - glm::dvec3(t.p[0]));
    area += glm::length(cross) / 2;
    normal += cross / 2.0;
  }
  return {area, normal};
}

template <class Number>
void append(std::string& bytes, const Number& number) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof(number));
}

/// The stream of a serialized mesh. `flags`: 2 for texture coordinates. `surplus` vertices are stated and not there.
template <class Real>
std::string serialized(int version, std::uint32_t flags, const std::vector<Real>& positions,
                       const std::vector<Real>& uv, const std::vector<std::uint32_t>& indices,
                       std::uint64_t surplus = 0) {
  std::string data;
  append(data, flags | (sizeof(Real) == 8 ? 0x2000u : 0x1000u));
  if (version == 4) data += std::string("name") + '\0';
  append(data, std::uint64_t{positions.size() / 3 + surplus});
  append(data, std::uint64_t{indices.size() / 3});
  for (const Real x : positions) append(data, x);
  for (const Real x : uv) append(data, x);
  for (const std::uint32_t index : indices) append(data, index);
  uLongf size = compressBound(data.size());
  std::string deflated(size, '\0');
  compress(reinterpret_cast<Bytef*>(deflated.data()), &size, reinterpret_cast<const Bytef*>(data.data()), data.size());
  return deflated.substr(0, size);
}

/// A file of serialized meshes, with the table at its end.
std::string fileOf(std::uint16_t version, const std::vector<std::string>& meshes) {
  std::string bytes, table;
  for (const std::string& mesh : meshes) {
    if (version >= 4) append(table, std::uint64_t{bytes.size()});
    if (version == 3) append(table, static_cast<std::uint32_t>(bytes.size()));
    append(bytes, std::uint16_t{0x041c});
    append(bytes, version);
    bytes += mesh;
  }
  append(table, static_cast<std::uint32_t>(meshes.size()));
  return bytes + table;
}

}  // namespace

TEST_CASE("Spheres and cylinders of Mitsuba are exact where their transform permits it") {
  const scene::Scene scene = xmlSceneOf(
      shape("sphere", R"(<point name="center" value="1 0 0"/><float name="radius" value="0.5"/>)" +
                          transform("<scale value=\"2\"/><translate z=\"1\"/>")) +
      shape("sphere", R"(<boolean name="flip_normals" value="true"/>)") +
      shape(
          "cylinder",
          R"(<point name="p0" x="0" y="0" z="1"/><point name="p1" x="0" y="3" z="1"/><float name="radius" value="0.25"/>)" +
              transform("<scale value=\"2\"/>")));
  REQUIRE(scene.spheres.size() == 2);
  CHECK(scene.spheres[0] == scene::Sphere{{2, 0, 1}, 1});
  CHECK(scene.spheres[1] == scene::Sphere{{0, 0, 0}, -1});
  REQUIRE(scene.cones.size() == 1);
  CHECK(scene.cones[0] == scene::Cone{{0, 0, 2}, 0.5f, {0, 6, 2}, 0.5f});
  CHECK(scene.meshes.empty());
}

TEST_CASE("Other spheres and cylinders are meshes on the exact surface, with its normals and coordinates") {
  for (const std::string& content : {transform("<scale x=\"2\"/>"), kMasked}) {
    const scene::Scene scene = xmlSceneOf(shape("sphere", content));
    CHECK(scene.spheres.empty());
    CHECK(scene.primitives.size() == 2 * 256 * 128);
    const double stretch = content == kMasked ? 1 : 2;
    const scene::Mesh& mesh = scene.meshes.at(0);
    for (std::size_t i = 0; i < mesh.positions.size(); i += 997) {
      const glm::dvec3 p = glm::dvec3(mesh.positions[i]) / glm::dvec3(stretch, 1, 1);
      CHECK(glm::length(p) == Approx(1).epsilon(1e-6));
      CHECK(near(mesh.normals[i], glm::normalize(p / glm::dvec3(stretch, 1, 1)), 1e-5));
      const glm::dvec2 uv(mesh.texCoords[0][i]);
      CHECK(std::cos(uv.y * std::numbers::pi) == Approx(p.z).margin(1e-5));
      if (std::abs(p.z) < 0.99) {
        CHECK(near(glm::vec3(glm::normalize(glm::dvec3(p.x, p.y, 0))),
                   {std::cos(2 * std::numbers::pi * uv.x), std::sin(2 * std::numbers::pi * uv.x), 0}, 1e-5));
      }
    }
    for (const scene::Primitive& primitive : scene.primitives) {
      const scene::Triangle t = triangleOf(scene, primitive);
      const glm::dvec3 normal = glm::cross(glm::dvec3(t.p[1]) - glm::dvec3(t.p[0]),
                                           glm::dvec3(t.p[2]) - glm::dvec3(t.p[0]));
      if (glm::dot(normal, glm::dvec3(t.p[0])) < 0) FAIL("a triangle of the sphere has its front inside");
    }
  }
  const scene::Scene tube = xmlSceneOf(shape("cylinder", kMasked));
  CHECK(tube.cones.empty());
  CHECK(areaOf(tube).first == Approx(2 * std::numbers::pi).epsilon(1e-4));
}

TEST_CASE("Rectangles, cubes and disks of Mitsuba have the area and the fronts of the exact shapes") {
  const auto [square, up] = areaOf(xmlSceneOf(shape("rectangle")));
  CHECK(square == 4);
  CHECK(up == glm::dvec3(0, 0, 4));
  CHECK(areaOf(xmlSceneOf(shape("rectangle", R"(<boolean name="flip_normals" value="true"/>)"))).second ==
        glm::dvec3(0, 0, -4));
  CHECK(areaOf(xmlSceneOf(shape("rectangle", transform("<scale x=\"-1\" y=\"2\"/>")))).second == glm::dvec3(0, 0, 8));
  const auto [disk, diskUp] = areaOf(xmlSceneOf(shape("disk")));
  CHECK(disk == Approx(std::numbers::pi).epsilon(1e-6));
  CHECK(diskUp.z == Approx(std::numbers::pi).epsilon(1e-6));
  const scene::Scene cube = xmlSceneOf(shape("cube"));
  CHECK(areaOf(cube).first == 24);
  for (const scene::Primitive& primitive : cube.primitives) {
    const scene::Triangle t = triangleOf(cube, primitive);
    CHECK(glm::dot(glm::cross(t.p[1] - t.p[0], t.p[2] - t.p[0]), t.p[0]) == 4);
  }
  const scene::Mesh& mesh = cube.meshes.at(0);
  REQUIRE(mesh.texCoords[0].size() == 24);
  CHECK(mesh.positions[0] == glm::vec3(1, -1, -1));
  CHECK(mesh.texCoords[0][0] == glm::vec2(0, 1));
}

TEST_CASE("Meshes of files have the normals and coordinates that Mitsuba gives them") {
  const TemporaryFolder folder;
  folder.write(
      "roof.obj",
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 0 1\nvt 0 .25\nvt 1 0\nvt 0 1\nusemtl x\nf 1/1 2/2 3/3\nf 2/2 1/1 4/3\n");
  folder.write(
      "leaf.ply",
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty float "
      "u\nproperty float v\nproperty float r\nproperty float g\nproperty float b\nelement face 1\nproperty list uchar "
      "int vertex_indices\nend_header\n0 0 0 0 .25 .5 1 0\n1 0 0 1 0 0 0 0\n0 1 0 0 1 0 0 0\n3 0 1 2\n");
  const auto meshOf = [&](const std::string& type, const std::string& file, const std::string& content = "") {
    return loadXml(shape(type, "<string name=\"filename\" value=\"" + file + "\"/>" + content), {}, "3.0.0",
                   folder.path(""))
        .scene.meshes.at(0);
  };
  const scene::Mesh smooth = meshOf("obj", "roof.obj");
  REQUIRE(smooth.normals.size() == 4);
  CHECK(smooth.normals[2] == glm::vec3(0, 0, 1));
  CHECK(near(smooth.normals[0], glm::normalize(glm::dvec3(0, 1, 2)), 1e-6));  // angles of 45 and 90 degrees
  CHECK(smooth.texCoords[0][0] == glm::vec2(0, 0.75f));
  const scene::Mesh flat = meshOf(
      "obj", "roof.obj",
      R"(<boolean name="face_normals" value="true"/><boolean name="flip_tex_coords" value="false"/>)");
  CHECK(flat.normals.empty());
  CHECK(flat.texCoords[0][0] == glm::vec2(0, 0.25f));
  const scene::Mesh flipped = meshOf("obj", "roof.obj", R"(<boolean name="flip_normals" value="true"/>)");
  CHECK(flipped.normals[2] == glm::vec3(0, 0, -1));
  CHECK(flipped.indices == std::vector<std::uint32_t>{0, 2, 1, 1, 3, 0});
  const scene::Mesh leaf = meshOf(
      "ply", "leaf.ply",
      R"(<bsdf type="diffuse"><texture type="mesh_attribute" name="reflectance"><string name="name" value="vertex_color"/></texture></bsdf>)");
  CHECK(leaf.texCoords[0][0] == glm::vec2(0, 0.25f));
  REQUIRE(leaf.colours.size() == 3);
  CHECK(near(glm::vec3(leaf.colours[0]), {0.5, 1, 0}));  // linear, unlike those of a PLY that is rendered alone
  CHECK(meshOf("ply", "leaf.ply").colours.empty());
  folder.write("broken.obj", "v 0 0 0\nf 1 2 3\n");
  const std::string errors = xmlErrorsOf(shape("obj", R"(<string name="filename" value="broken.obj"/>)"), {}, "3.0.0",
                                         folder.path(""));
  CHECK(errors.find("broken.obj:2:") != std::string::npos);
  CHECK(xmlErrorsOf(shape("ply", R"(<string name="filename" value="no.ply"/>)"), {}, "3.0.0", folder.path(""))
            .find("test.xml:2:1: ") != std::string::npos);
}

// Two triangles with a common side: their colours need vertices of their own, whose normals stay smooth.
TEST_CASE("Attributes of meshes are the colours of vertices or of faces") {
  const TemporaryFolder folder;
  folder.write(
      "roof.ply",
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nproperty "
      "uchar red\nproperty uchar green\nproperty uchar blue\nproperty float pair_0\nproperty float "
      "pair_1\nelement face 2\nproperty float color_r\nproperty float color_g\nproperty float color_b\nproperty "
      "list uchar int vertex_indices\nproperty double weight_1\nend_header\n0 0 0 0 51 255 0 0\n1 0 0 0 0 0 0 "
      "0\n0 1 0 0 0 0 0 0\n1 0 1 0 0 0 0 0\n0.25 0.5 2 3 0 1 2 0.125\n1 0 0 3 1 0 3 0.75\n");
  const auto withAttribute = [](const std::string& name) {
    return shape(
        "ply",
        R"(<string name="filename" value="roof.ply"/><bsdf type="diffuse"><texture type="mesh_attribute" name="reflectance"><string name="name" value=")" +
            name + R"("/></texture></bsdf>)");
  };
  const auto meshOf = [&](const std::string& name) {
    return loadXml(withAttribute(name), {}, "3.0.0", folder.path("")).scene.meshes.at(0);
  };
  const scene::Mesh faces = meshOf("face_color");
  const glm::vec4 first(0.25f, 0.5f, 1, 1), second(1, 0, 0, 1);
  CHECK(faces.colours == std::vector<glm::vec4>{first, first, first, second, second, second});
  CHECK(faces.indices == std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5});
  REQUIRE(faces.normals.size() == 6);
  CHECK(faces.positions[4] == glm::vec3(0));
  CHECK(faces.normals[0] == faces.normals[4]);
  CHECK(near(faces.normals[0], glm::normalize(glm::dvec3(0, 1, 2))));
  CHECK(meshOf("face_weight").colours[3] == glm::vec4(0.75f, 0.75f, 0.75f, 1));
  const std::string weight = R"(><string name="name" value="face_weight"/></texture>)";
  for (
      const std::string& bsdf :
      {R"(<bsdf type="blendbsdf"><bsdf type="diffuse"/><bsdf type="diffuse"/><texture type="mesh_attribute" name="weight")" +
           weight,
       R"(<bsdf type="mask"><bsdf type="diffuse"/><texture type="mesh_attribute" name="opacity")" + weight}) {
    const std::string ply = R"(<string name="filename" value="roof.ply"/>)";
    const scene::Scene weighted = loadXml(shape("ply", ply + bsdf + "</bsdf>"), {}, "3.0.0", folder.path("")).scene;
    CHECK(weighted.meshes.at(0).colours.at(3) == glm::vec4(1, 1, 1, 0.75f));
  }
  const scene::Mesh vertices = meshOf("vertex_color");
  REQUIRE(vertices.colours.size() == 4);
  CHECK(near(glm::vec3(vertices.colours[0]), {0, image::srgbDecode(0.2), 1}));  // integers are encoded
  const auto errorOf = [&](const std::string& name) {
    return xmlErrorsOf(withAttribute(name), {}, "3.0.0", folder.path(""));
  };
  CHECK_THAT(errorOf("vertex_pair"), Catch::Contains("no attribute \"vertex_pair\" of one or three channels"));
  CHECK_THAT(errorOf("vertex_weight"), Catch::Contains("no attribute \"vertex_weight\""));
  CHECK_THAT(errorOf("color"), Catch::Contains("begins neither with \"vertex_\" nor with \"face_\""));
  const scene::LoadedScene white = loadXml(withAttribute("face_pair"), {.lenient = true}, "3.0.0", folder.path(""));
  CHECK(white.scene.meshes.at(0).colours.empty());
}

TEST_CASE("Meshes of Mitsuba's binary format are read in both versions and precisions") {
  const TemporaryFolder folder;
  const std::vector<float> positions{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}, uv{0, .25f, 1, 0, 0, 1, 1, 1};
  const std::vector<std::uint32_t> indices{0, 1, 2, 1, 3, 2};
  const std::string flat = serialized(4, 0, positions, {}, indices);
  const std::string full = serialized(4, 2, std::vector<double>(positions.begin(), positions.end()),
                                      std::vector<double>(uv.begin(), uv.end()), indices);
  folder.write("two.serialized", fileOf(4, {flat, full}));
  folder.write("old.serialized", fileOf(3, {serialized(3, 2, positions, uv, indices)}));
  const auto meshOf = [&](const std::string& file, const std::string& content) {
    return loadXml(shape("serialized", "<string name=\"filename\" value=\"" + file + "\"/>" + content), {}, "3.0.0",
                   folder.path(""))
        .scene.meshes.at(0);
  };
  const scene::Mesh first = meshOf("two.serialized", "");
  CHECK(first.positions == std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}});
  CHECK(first.indices == indices);
  CHECK(first.normals == std::vector<glm::vec3>(4, glm::vec3(0, 0, 1)));
  CHECK(first.texCoords[0].empty());
  const scene::Mesh second = meshOf("two.serialized", "<integer name=\"shape_index\" value=\"1\"/>");
  CHECK(second.positions == first.positions);
  CHECK(second.texCoords[0][0] == glm::vec2(0, 0.25f));
  CHECK(meshOf("old.serialized", "").texCoords[0] == second.texCoords[0]);
  const auto errorOf = [&](const std::string& bytes, const std::string& content = "") {
    folder.write("bad.serialized", bytes);
    return xmlErrorsOf(shape("serialized", "<string name=\"filename\" value=\"bad.serialized\"/>" + content), {},
                       "3.0.0", folder.path(""));
  };
  CHECK_THAT(errorOf("ply"), Catch::Contains("test.xml:2:1: \"bad.serialized\" is not a serialized mesh"));
  CHECK_THAT(errorOf(fileOf(5, {flat})), Catch::Contains("serialized meshes of version 5 are not read"));
  CHECK_THAT(errorOf(fileOf(4, {flat}), "<integer name=\"shape_index\" value=\"1\"/>"),
             Catch::Contains("there is no mesh 1: the file has 1, counted from 0"));
  CHECK_THAT(errorOf(fileOf(4, {serialized(4, 0, positions, {}, {0, 1, 4})})), Catch::Contains("there is no vertex 4"));
  CHECK_THAT(errorOf(fileOf(4, {serialized(4, 0, positions, {}, {})})), Catch::Contains("has no triangles"));
  CHECK_THAT(errorOf(fileOf(4, {serialized(4, 0, positions, {}, indices, 1u << 30)})),
             Catch::Contains("are more than the file can contain"));
  CHECK_THAT(errorOf(fileOf(4, {flat.substr(0, 20)})), Catch::Contains("end too early, or are damaged"));
  CHECK_THAT(errorOf(fileOf(4, {serialized(4, 0, std::vector<double>(12, 1e300), {}, indices)})),
             Catch::Contains("not finite in single precision"));
}

TEST_CASE("Instances show the shapes of a group at their placements") {
  const TemporaryFolder folder;
  const std::string group = "<shape type=\"shapegroup\" id=\"g\">" +
                            shape("cube", "<bsdf type=\"conductor\"/>" + transform("<translate x=\"2\"/>")) +
                            shape("sphere") + "</shape>";
  const auto instance = [](const std::string& operations) {
    return shape("instance", "<ref id=\"g\"/>" + transform(operations));
  };
  const scene::Scene scene = xmlSceneOf(group + instance("<scale value=\"2\"/>") + instance("<scale x=\"-1\"/>"));
  CHECK(scene.meshes.size() == 2);  // one for the placement that mirrors
  CHECK(scene.placements.size() == 2);
  CHECK(scene.primitives.size() == 2 * 12 + 2);
  CHECK(scene.spheres.at(0) == scene::Sphere{{0, 0, 0}, 2});
  for (const scene::Primitive& primitive : scene.primitives) {
    if (primitive.kind != scene::PrimitiveKind::triangle) continue;
    const scene::Triangle t = triangleOf(scene, primitive);
    const glm::vec3 centre = primitive.placement == 0 ? glm::vec3(4, 0, 0) : glm::vec3(-2, 0, 0);
    CHECK(glm::dot(glm::cross(t.p[1] - t.p[0], t.p[2] - t.p[0]), t.p[0] - centre) > 0);
  }
  CHECK(xmlSceneOf(group).primitives.empty());
  CHECK(xmlErrorsOf("<shape type=\"shapegroup\" id=\"g\">" + shape("cube", kEmitter) + "</shape>" + instance(""))
            .find("an instance does not emit light") != std::string::npos);
}

// A black surface behind an emitter hides its back, which does not shine in Mitsuba.
TEST_CASE("Emitters that are not closed have a black back") {
  const scene::Scene scene = xmlSceneOf(shape("rectangle", kEmitter + transform("<scale value=\"4\"/>")));
  REQUIRE(scene.materials.size() == 2);
  CHECK(scene.materials[0].emission == glm::vec3(3, 2, 1));
  CHECK(kindOf(scene.materials[0]) == scene::MaterialKind::black);
  CHECK_FALSE(isEmissive(scene.materials[1]));
  CHECK(kindOf(scene.materials[1]) == scene::MaterialKind::black);
  REQUIRE(scene.primitives.size() == 4);
  const double distance = 4 * std::ldexp(1.0, -16);
  for (std::uint32_t i = 0; i < 2; ++i) {
    CHECK(scene.primitives[i].material == 1);
    for (const glm::vec3& corner : triangleOf(scene, scene.primitives[i]).p) {
      CHECK(corner.z == static_cast<float>(-distance));
      CHECK(std::max(std::abs(corner.x), std::abs(corner.y)) > 4);
      CHECK(std::max(std::abs(corner.x), std::abs(corner.y)) <= 4 + 20 * distance);
    }
  }
  CHECK(xmlSceneOf(shape("cube", kEmitter)).primitives.size() == 12);
  CHECK(xmlSceneOf(shape("sphere", kEmitter)).primitives.size() == 1);
  const scene::Scene tube = xmlSceneOf(shape("cylinder", kEmitter));
  REQUIRE(tube.cones.size() == 2);
  CHECK(tube.cones[1].baseRadius < 1);
  CHECK(tube.cones[1].baseRadius > 0.9999f);
}

}  // namespace candela::mitsuba
