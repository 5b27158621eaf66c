// The table of kinds of scenes.
#include "host/scene/generate/kinds.h"

#include <array>

#include "host/scene/generate/databases.h"
#include "host/scene/generate/gltf_scenes.h"
#include "host/scene/generate/many_lights.h"

namespace candela::generate {

std::uint32_t Kind::maxSize() const {
  if (maxInstances > 0) return maxInstances;
  std::uint32_t size = minSize;
  while (primitiveCount(size + 1) <= kMaxPrimitives) ++size;
  return size;
}

std::span<const Kind> kindTable() {
  // The default sizes are those of the original programs. Those of terrain, sphere and cornell give about a million,
  // 70,000 and 20,000 triangles.
  static constexpr std::array<Kind, 25> table{{
      {"balls", "sphereflake: each ball has nine smaller balls", 1, 4, ballsPrimitives, writeBalls},
      {"mount", "fractal mountain of triangles, and four glass balls", 1, 6, mountPrimitives, writeMount},
      {"tetra", "Sierpinski's tetrahedron of triangles", 1, 6, tetraPrimitives, writeTetra},
      {"rings", "pyramid of interlocked rings of spheres and cylinders", 1, 7, ringsPrimitives, writeRings},
      {"gears", "meshing gears with concave 144-gons, some of glass", 1, 4, gearsPrimitives, writeGears},
      {"tree", "tree of cones and spheres, seven lights", 1, 11, treePrimitives, writeTree},
      {"jacks", "jacks within jacks: cylinders and spheres", 1, 1, jacksPrimitives, writeJacks},
      {"lattice", "cubic lattice of spheres and cylinders", 1, 12, latticePrimitives, writeLattice},
      {"shells", "sea shell of overlapping spheres: hard for grids", 1, 5, shellsPrimitives, writeShells},
      {"sombrero", "ripples as a height field", 1, 1, sombreroPrimitives, writeSombrero},
      {"teapot", "Newell's teapot, as triangles with normals", 1, 6, teapotPrimitives, writeTeapot},
      {"terrain", "hills, one mesh of N x N vertices", 2, 708, terrainPrimitives, writeTerrain},
      {"sphere", "bumpy sphere, one mesh in a closed room with a light", 1, 76, spherePrimitives, writeSphere},
      {"cornell", "Cornell box with a mirror and a glass ball, one mesh each", 1, 29, cornellPrimitives, writeCornell},
      {"material-table", "glTF: balls of six roughnesses, of metal, plastic and glass", 8, 32, materialTablePrimitives,
       writeMaterialTable, true},
      {"material-furnace", "glTF: balls that absorb nothing, for --env white", 8, 32, materialFurnacePrimitives,
       writeMaterialFurnace, true},
      {"brushed-table", "glTF: balls of six roughnesses, with anisotropic highlights", 8, 32, brushedTablePrimitives,
       writeBrushedTable, true},
      {"brilliants", "glTF: three diamonds of growing dispersion between lamps", 6, 8, brilliantsPrimitives,
       writeBrilliants, true},
      {"still-life", "glTF: a vase, glasses, a bowl and balls on tiles, for --env", 8, 64, stillLifePrimitives,
       writeStillLife, true},
      {"forest", "glTF: trees around a lake, instances of five models, for --env", 1, 2000, forestPrimitives,
       writeForest, true, 50'000},
      {"city", "glTF: streets of buildings, instances of five models, for --env", 1, 1000, cityPrimitives, writeCity,
       true, 50'000},
      {"corridor", "N lamps of unequal power in a corridor and rooms beside it", 1, 1000, corridorPrimitives,
       writeCorridor},
      {"street", "glTF: streets at night, N emissive triangles", 2, 10'000, streetPrimitives, writeStreet, true},
      {"office", "open-plan office, N equal light panels", 1, 100, officePrimitives, writeOffice},
      {"floodlights", "N equal lamps, far away from a small stage", 1, 1000, floodlightsPrimitives, writeFloodlights},
  }};
  return table;
}

void generateScene(const Kind& kind, std::uint32_t size, NffWriter::Sink sink) {
  NffWriter out(std::move(sink));
  kind.write(out, size);
  out.finish();
}

}  // namespace candela::generate
