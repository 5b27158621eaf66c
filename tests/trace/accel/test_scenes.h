// Scenes for searches: every scene file, and extreme scenes.
#pragma once
#include <string>
#include <vector>

#include "host/scene/scene.h"

namespace candela::test {

struct NamedScene {
  std::string name;
  scene::Scene scene;
};

/// The files of scenes/ and tests/formats/nff/spd/.
std::vector<NamedScene> sceneFiles();
/// Flat scenes, one object and none, overlapping shells, boxes of zero thickness, objects that differ much in position
/// and size, objects on the faces of cells, half of everything twice.
std::vector<NamedScene> edgeScenes();
/// `count` triangles and spheres in a cube.
scene::Scene largeScene(std::size_t count);

}  // namespace candela::test
