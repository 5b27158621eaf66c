// Names of objects and materials, and their ids in mattes.
#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "host/image/film.h"
#include "host/image/mattes.h"
#include "host/scene/scene.h"

namespace candela::scene {

/// Returns a noun: "sphere", "triangle", "box", "cone" or "plane".
std::string kindName(PrimitiveKind kind);
/// Returns the name that the file states, or else one that follows from the index: the kind of the first primitive and
/// the index of the object, as `sphere.3`, or `material.3`. A scene that states no objects is one, `scene`.
std::string objectName(const Scene& scene, std::size_t object);
std::string materialName(const Scene& scene, std::size_t material);
/// Returns the index of the object to which a primitive, an index into Scene::primitives, belongs.
std::size_t objectOf(const Scene& scene, std::uint32_t primitive);

/// The ids of a scene's objects and materials. Two with the same name have the same id.
class MatteIds {
 public:
  explicit MatteIds(const Scene& scene);

  /// Returns the id of the object or of the material of a primitive, an index into Scene::primitives.
  std::uint32_t of(image::MatteKind kind, std::uint32_t primitive) const;

 private:
  const Scene& scene_;
  std::vector<std::uint32_t> objects_, materials_;
};

/// Returns the names of all objects or materials of a scene by their ids.
std::map<std::uint32_t, std::string> matteNamesById(const Scene& scene, image::MatteKind kind);

/// Returns the names of all ids that the pixels of a film have.
image::MatteNames matteNamesOf(const Scene& scene, const image::Film& film);

}  // namespace candela::scene
