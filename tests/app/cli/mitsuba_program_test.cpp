// Scenes of Mitsuba, written for this test, give the film of the same scene in NFF.
#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "tests/app/cli/run_program.h"

namespace candela {
namespace {

std::string mitsubaPicture(const TemporaryFolder& folder, const std::string& scene,
                           std::vector<std::string> options = {}) {
  const std::string picture = folder.path("picture.pfm");
  std::vector<std::string> words{scene, "--device", "cpu", "-o", picture};
  words.insert(words.end(), options.begin(), options.end());
  const ProgramResult result = runCandela(words);
  INFO(result.err);
  REQUIRE(result.exitCode == 0);
  return readText(picture);
}

/// Objects of several materials between two lights. The view is at the distance to the centre of its bounding box.
const std::string kMitsuba = R"(<scene version="3.0.0">
<default name="spp" value="4"/>
<integrator type="path"><integer name="max_depth" value="5"/></integrator>
<sensor type="perspective"><float name="fov" value="40"/><string name="fov_axis" value="y"/>
<transform name="to_world"><lookat origin="0, 2, 8" target="0, 2, 0" up="0, 1, 0"/></transform>
<film type="hdrfilm"><integer name="width" value="32"/><integer name="height" value="24"/><rfilter type="tent"/></film>
<sampler type="independent"><integer name="sample_count" value="$spp"/></sampler></sensor>
<emitter type="constant"><rgb name="radiance" value="0.25 0.5 0.75"/></emitter>
<bsdf type="twosided" id="wall"><bsdf type="diffuse"><rgb name="reflectance" value="0.75 0.5 0.25"/></bsdf></bsdf>
<shape type="rectangle"><ref id="wall"/><transform name="to_world"><rotate x="1" angle="-90"/><scale value="4"/></transform></shape>
<shape type="sphere"><point name="center" x="-1.5" y="1" z="0"/><bsdf type="conductor">
<rgb name="specular_reflectance" value="0.5 0.75 1"/></bsdf></shape>
<shape type="sphere"><transform name="to_world"><scale value="0.5"/><translate x="1.5" y="1"/></transform><bsdf type="conductor"/></shape>
<shape type="cylinder"><point name="p0" x="0" y="0" z="1"/><point name="p1" x="0" y="1" z="1"/><float name="radius" value="0.25"/><ref id="wall"/></shape>
<shape type="sphere"><point name="center" x="0" y="3.75" z="0"/><float name="radius" value="0.25"/>
<emitter type="area"><rgb name="radiance" value="9 8 7"/></emitter></shape>
</scene>
)";

const std::string kSameNff = R"(v
from 0 2 8
at 0 2 0
up 0 1 0
angle 40
hither 0
resolution 32 24
b .25 .5 .75
f .75 .5 .25 1 0 0 0 0
p 3
-4 0 4
4 0 4
4 0 -4
p 3
-4 0 4
4 0 -4
-4 0 -4
f .5 .75 1 0 1 0 0 0
s -1.5 1 0 1
f 1 1 1 0 1 0 0 0
s 1.5 1 0 .5
f .75 .5 .25 1 0 0 0 0
c
0 0 1 .25
0 1 1 .25
f 0 0 0 1 0 0 0 0 1 0 1 9 8 7
s 0 3.75 0 .25
)";

}  // namespace

TEST_CASE("A scene of Mitsuba and one of NFF give the same film") {
  const TemporaryFolder folder;
  const std::string xml = folder.write("scene.xml", kMitsuba);
  const std::string nff = folder.write("scene.nff", kSameNff);
  const std::vector<std::string> settings{"--spp", "4", "--max-depth", "5", "--filter", "tent"};
  const std::string film = mitsubaPicture(folder, nff, settings);
  CHECK(mitsubaPicture(folder, xml) == film);
  CHECK(mitsubaPicture(folder, folder.write("other.name", kMitsuba)) == film);
  CHECK(mitsubaPicture(folder, xml, {"--define", "spp=2"}) != film);
  CHECK(mitsubaPicture(folder, xml, {"-D", "spp=2", "--spp", "4"}) == film);
  CHECK(mitsubaPicture(folder, xml, {"--max-depth", "2"}) != film);
  CHECK(mitsubaPicture(folder, xml, {"--filter", "box"}) != film);
}

TEST_CASE("Definitions are for scenes of Mitsuba alone, and each must have a use") {
  const TemporaryFolder folder;
  const ProgramResult nff = runCandela({"check", folder.write("scene.nff", kSameNff), "-D", "spp=2"});
  CHECK(nff.exitCode == 1);
  CHECK(nff.err.find("--define spp=2: ") != std::string::npos);
  const ProgramResult unused = runCandela({"check", folder.write("scene.xml", kMitsuba), "-D", "sp=2"});
  CHECK(unused.exitCode == 2);
  CHECK(unused.err.find("scene.xml:1:1: no attribute contains $sp") != std::string::npos);
}

}  // namespace candela
