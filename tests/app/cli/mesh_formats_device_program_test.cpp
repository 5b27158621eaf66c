// Models in PLY and OBJ on a Vulkan device: it computes the light that the reference computes.
#include <catch2/catch.hpp>
#include <cstdlib>

#include "host/image/codecs.h"
#include "tests/app/cli/run_program.h"

namespace candela {
namespace {

void checkOnDevice(const std::string& scene) {
  std::vector<std::string> words{"verify", scene, "--size", "32x32", "--bias", "5%"};
  if (const char* device = std::getenv("CANDELA_TEST_DEVICE")) words.insert(words.end(), {"--device", device});
  const ProgramResult result = runCandela(words);
  INFO(result.out << result.err);
  CHECK(result.exitCode == 0);
}

}  // namespace

TEST_CASE("A device renders a PLY with normals and colours as the reference does") {
  const TemporaryFolder folder;
  checkOnDevice(
      folder.write("a.ply",
                   "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
                   "property float nx\nproperty float ny\nproperty float nz\nproperty uchar red\nproperty uchar green\n"
                   "property uchar blue\nproperty uchar alpha\nelement face 1\nproperty list uchar int vertex_indices\n"
                   "end_header\n-1 -1 0 -1 -1 2 255 0 0 255\n1 -1 0 1 -1 2 0 255 0 128\n1 1 0 1 1 2 0 0 255 255\n"
                   "-1 1 0 -1 1 2 255 255 255 64\n4 0 1 2 3\n"));
}

TEST_CASE("A device renders an OBJ with maps, gloss and a lamp as the reference does") {
  const TemporaryFolder folder;
  const image::Bytes png = image::encodePng({2, 2, {255, 40, 0, 0, 255, 90, 20, 0, 255, 255, 255, 255}});
  folder.write("a.png", {reinterpret_cast<const char*>(png.data()), png.size()});
  folder.write("a.mtl",
               "newmtl gloss\nKd .2 .3 .4\nKs .5 .4 .3\nNs 40\nmap_Kd -s 2 2 a.png\nmap_Ks a.png\nnewmtl rough\n"
               "Kd .7 .7 .7\nPr .4\nPm .8\nmap_Pr a.png\nnewmtl lamp\nKd 0 0 0\nKe 6 5 4\n");
  checkOnDevice(
      folder.write("a.obj",
                   "mtllib a.mtl\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nv -1 -1 2\nv 1 -1 2\nvt 0 0\nvt 1 0\n"
                   "vt 1 1\nvt 0 1\nusemtl gloss\nf 1/1 2/2 3/3 4/4\nusemtl rough\nf 1/1 5/2 6/3 2/4\nv -1 2 0\n"
                   "v 1 2 0\nv 0 2 2\nusemtl lamp\nf 7 8 9\n"));
}

}  // namespace candela
