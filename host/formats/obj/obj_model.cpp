// Computes normals of smoothing groups.
#include "host/formats/obj/obj_model.h"

#include <algorithm>
#include <cmath>

#include "host/formats/loading/vertex_normals.h"

namespace candela::obj {
namespace {

/// The angle between two vectors; 0 if one has no length.
double angleBetween(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

}  // namespace

std::uint32_t SmoothNormals::find(std::uint32_t position, std::uint32_t group) {
  constexpr int kMaxSteps = 64;  // more groups at a vertex get a normal for each face, so that the time stays linear
  if (position >= first_.size()) first_.resize(position + std::size_t{1}, kNone);
  std::uint32_t entry = first_[position];
  for (int step = 0; entry != kNone && step < kMaxSteps; ++step) {
    if (entries_[entry].group == group) return entry;
    entry = entries_[entry].next;
  }
  entries_.push_back({group, first_[position]});
  sums_.emplace_back(0);
  return first_[position] = static_cast<std::uint32_t>(entries_.size() - 1);
}

void SmoothNormals::add(const std::uint32_t (&normals)[3], const glm::vec3 (&points)[3]) {
  const glm::dvec3 p[3]{glm::dvec3(points[0]), glm::dvec3(points[1]), glm::dvec3(points[2])};
  const glm::dvec3 normal(scene::unitNormalOrZero(glm::cross(p[1] - p[0], p[2] - p[0])));
  for (int i = 0; i < 3; ++i) {
    const glm::dvec3& corner = p[i];
    sums_[normals[i]] += angleBetween(p[(i + 1) % 3] - corner, p[(i + 2) % 3] - corner) * normal;
  }
}

glm::vec3 SmoothNormals::at(std::uint32_t normal) const { return scene::unitNormalOrZero(sums_[normal]); }

}  // namespace candela::obj
