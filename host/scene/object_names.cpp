// Generates names where a file has none.
#include "host/scene/object_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace candela::scene {
namespace {

std::size_t countOf(const Scene& scene, image::MatteKind kind) {
  return kind == image::MatteKind::object ? std::max<std::size_t>(scene.objectStarts.size(), 1)
                                          : scene.materials.size();
}

std::string nameOf(const Scene& scene, image::MatteKind kind, std::size_t index) {
  return kind == image::MatteKind::object ? objectName(scene, index) : materialName(scene, index);
}

std::vector<std::uint32_t> idsOf(const Scene& scene, image::MatteKind kind) {
  std::vector<std::uint32_t> ids;
  for (std::size_t i = 0; i < countOf(scene, kind); ++i) ids.push_back(image::matteId(nameOf(scene, kind, i)));
  return ids;
}

std::set<std::uint32_t> idsIn(const image::Film& film, image::MatteKind kind) {
  std::set<std::uint32_t> ids;
  for (const image::IdCounts& counts : film.ids(kind)) {
    for (const image::IdCount& entry : counts) ids.insert(entry.id);
  }
  return ids;
}

std::vector<std::string> namesOf(const Scene& scene, const image::Film& film, image::MatteKind kind) {
  if (film.ids(kind).empty()) return {};
  const std::set<std::uint32_t> used = idsIn(film, kind);
  std::set<std::string> names;
  for (std::size_t i = 0; i < countOf(scene, kind); ++i) {
    std::string name = nameOf(scene, kind, i);
    if (used.contains(image::matteId(name))) names.insert(std::move(name));
  }
  return {names.begin(), names.end()};
}

}  // namespace

std::string kindName(PrimitiveKind kind) {
#define CANDELA_NAME_KIND(entry, feature, name, value, flag) \
  if (kind == PrimitiveKind::entry) return #entry;
  CANDELA_PRIMITIVE_KINDS(CANDELA_NAME_KIND)
#undef CANDELA_NAME_KIND
  return "object";
}

std::string objectName(const Scene& scene, std::size_t object) {
  if (!scene.objectNames.empty()) return scene.objectNames[object];
  if (scene.objectStarts.empty()) return "scene";
  return fmt::format("{}.{}", kindName(scene.primitives[scene.objectStarts[object]].kind), object);
}

std::string materialName(const Scene& scene, std::size_t material) {
  return material < scene.materialNames.size() ? scene.materialNames[material] : fmt::format("material.{}", material);
}

std::size_t objectOf(const Scene& scene, std::uint32_t primitive) {
  const auto next = std::ranges::upper_bound(scene.objectStarts, primitive) - scene.objectStarts.begin();
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(next, 1) - 1);
}

MatteIds::MatteIds(const Scene& scene)
    : scene_(scene),
      objects_(idsOf(scene, image::MatteKind::object)),
      materials_(idsOf(scene, image::MatteKind::material)) {}

std::uint32_t MatteIds::of(image::MatteKind kind, std::uint32_t primitive) const {
  if (kind == image::MatteKind::material) return materials_[scene_.primitives[primitive].material];
  return objects_[objectOf(scene_, primitive)];
}

std::map<std::uint32_t, std::string> matteNamesById(const Scene& scene, image::MatteKind kind) {
  std::map<std::uint32_t, std::string> names;
  for (std::size_t i = 0; i < countOf(scene, kind); ++i) {
    std::string name = nameOf(scene, kind, i);
    const std::uint32_t id = image::matteId(name);
    names.try_emplace(id, std::move(name));
  }
  return names;
}

image::MatteNames matteNamesOf(const Scene& scene, const image::Film& film) {
  return {namesOf(scene, film, image::MatteKind::object), namesOf(scene, film, image::MatteKind::material)};
}

}  // namespace candela::scene
