// The same model in several formats, written for this test, gives the same film.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/app/cli/run_program.h"

namespace candela {
namespace {

using nlohmann::json;

/// The vertices of an octahedron on a square.
const std::string kVertices = R"(1 .1 0
-1 .1 0
0 1.1 0
0 -.9 0
0 .1 1
0 .1 -1
-2 -1 2
2 -1 2
2 -1 -2
-2 -1 -2
)";

const std::string kPly = R"(ply
format ascii 1.0
element vertex 10
property float x
property float y
property float z
element face 9
property list uchar int vertex_indices
end_header
)" + kVertices +
                         R"(3 0 2 4
3 2 1 4
3 1 3 4
3 3 0 4
3 2 0 5
3 1 2 5
3 3 1 5
3 0 3 5
4 6 7 8 9
)";

/// The same in OBJ, whose indices count from 1.
const std::string kObj = R"(v 1 .1 0
v -1 .1 0
v 0 1.1 0
v 0 -.9 0
v 0 .1 1
v 0 .1 -1
v -2 -1 2
v 2 -1 2
v 2 -1 -2
v -2 -1 -2
f 1 3 5
f 3 2 5
f 2 4 5
f 4 1 5
f 3 1 6
f 2 3 6
f 4 2 6
f 1 4 6
f 7 8 9 10
)";

/// The statement `mesh` of the same vertices, whose indices count from 1, and the same material.
const std::string kNff = R"(f .8 .8 .8 1 0 0 0 0
mesh 10 10
)" + kVertices +
                         R"(1 3 5
3 2 5
2 4 5
4 1 5
3 1 6
2 3 6
4 2 6
1 4 6
10 7 8
10 8 9
)";

/// The view that the program chose for a file, as NFF states it.
std::string viewOf(const std::string& file) {
  const ProgramResult result = runCandela({"check", file, "--json", "-"});
  REQUIRE(result.exitCode == 0);
  const json camera = json::parse(result.out).at("files").at(0).at("report").at("camera");
  const auto numbers = [&](const char* name) {
    const json& v = camera.at(name);
    return fmt::format("{} {} {} {}\n", name, v[0].get<float>(), v[1].get<float>(), v[2].get<float>());
  };
  return "v\n" + numbers("from") + numbers("at") + numbers("up") +
         fmt::format("angle {}\nhither 0\nresolution 512 512\n", camera.at("angle").get<float>());
}

std::string pictureOf(const TemporaryFolder& folder, const std::string& scene) {
  const std::string picture = folder.path("picture.pfm");
  const ProgramResult result = runCandela(
      {scene, "--device", "cpu", "--env", "sun:40,120,3", "--size", "32x32", "--spp", "4", "-o", picture});
  INFO(result.err);
  REQUIRE(result.exitCode == 0);
  return readText(picture);
}

}  // namespace

TEST_CASE("A PLY, an OBJ and an NFF of the same mesh give the same film") {
  const TemporaryFolder folder;
  const std::string ply = folder.write("model.ply", kPly);
  const std::string obj = folder.write("model.obj", kObj);
  const std::string nff = folder.write("model.nff", viewOf(ply) + kNff);
  const std::string film = pictureOf(folder, ply);
  CHECK(film == pictureOf(folder, nff));
  CHECK(film == pictureOf(folder, obj));
  std::string other = kPly;
  const std::string moved = folder.write("moved.ply", other.replace(other.find("0 1.1 0"), 7, "0 1.2 0"));
  CHECK(film != pictureOf(folder, moved));
}

TEST_CASE("Materials of an OBJ give the film of those of NFF") {
  const TemporaryFolder folder;
  folder.write("model.mtl",
               "newmtl lamp\nKd 0 0 0\nKe 9 8 7\nnewmtl glass\nNi 1.5\nTf .9 .8 .7\nillum 7\n"
               "newmtl floor\nKd .25 .5 .75\n");
  const std::string obj = folder.write("model.obj",
                                       "mtllib model.mtl\nv -1 2 -1\nv 1 2 -1\nv 0 2 1\nusemtl lamp\nf 1 2 3\n"
                                       "v 1 0 0\nv -1 0 0\nv 0 1 0\nv 0 0 1\nusemtl glass\nf 4 6 7\nf 6 5 7\nf 5 4 7\n"
                                       "f 6 4 5\nv -2 -1 2\nv 2 -1 2\nv 2 -1 -2\nusemtl floor\nf 8 9 10\n");
  const std::string nff = folder.write("model.nff",
                                       viewOf(obj) +
                                           "f 0 0 0 1 0 0 0 0 1 0 1 9 8 7\n"
                                           "mesh 3 1\n-1 2 -1\n1 2 -1\n0 2 1\n1 2 3\n"
                                           "f .9 .8 .7 0 0 0 0 0 1 1 1.5 0 0 0\n"
                                           "mesh 4 4\n1 0 0\n-1 0 0\n0 1 0\n0 0 1\n1 3 4\n3 2 4\n2 1 4\n3 1 2\n"
                                           "f .25 .5 .75 1 0 0 0 0 1 0 1 0 0 0\n"
                                           "mesh 3 1\n-2 -1 2\n2 -1 2\n2 -1 -2\n1 2 3\n");
  CHECK(pictureOf(folder, obj) == pictureOf(folder, nff));
}

}  // namespace candela
