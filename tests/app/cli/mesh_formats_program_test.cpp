// The same model in several formats, written for this test, gives the same film.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/app/cli/run_program.h"

namespace candela {
namespace {

using nlohmann::json;

/// An octahedron on a square.
const std::string kPly = R"(ply
format ascii 1.0
element vertex 10
property float x
property float y
property float z
element face 9
property list uchar int vertex_indices
end_header
1 .1 0
-1 .1 0
0 1.1 0
0 -.9 0
0 .1 1
0 .1 -1
-2 -1 2
2 -1 2
2 -1 -2
-2 -1 -2
3 0 2 4
3 2 1 4
3 1 3 4
3 3 0 4
3 2 0 5
3 1 2 5
3 3 1 5
3 0 3 5
4 6 7 8 9
)";

/// The statement `mesh` of the same vertices, whose indices count from 1, and the same material.
const std::string kNff = R"(f .8 .8 .8 1 0 0 0 0
mesh 10 10
1 .1 0
-1 .1 0
0 1.1 0
0 -.9 0
0 .1 1
0 .1 -1
-2 -1 2
2 -1 2
2 -1 -2
-2 -1 -2
1 3 5
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

TEST_CASE("A PLY and an NFF of the same mesh give the same film") {
  const TemporaryFolder folder;
  const std::string ply = folder.write("model.ply", kPly);
  const std::string nff = folder.write("model.nff", viewOf(ply) + kNff);
  const std::string film = pictureOf(folder, ply);
  CHECK(film == pictureOf(folder, nff));
  std::string other = kPly;
  const std::string moved = folder.write("moved.ply", other.replace(other.find("0 1.1 0"), 7, "0 1.2 0"));
  CHECK(film != pictureOf(folder, moved));
}

}  // namespace candela
