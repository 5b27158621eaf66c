// The constant colour and the sky box.
#include "host/trace/reference/background.h"

#include <algorithm>
#include <cmath>

namespace candela::reference {
namespace {

double decodeSrgb(double value) { return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4); }

enum Face { kRight, kLeft, kTop, kBottom, kFront, kBack };

}  // namespace

Background::Background(const scene::Scene& scene) : scene_(scene) {
  for (std::size_t i = 0; i < linear_.size(); ++i) linear_[i] = decodeSrgb(static_cast<double>(i) / 255);
}

dvec3 Background::radiance(const dvec3& direction) const {
  if (!scene_.sky) return scene_.background;
  const scene::SkyFace(&faces)[6] = scene_.sky->faces;
  const dvec3 size = glm::abs(direction);
  if (size.x >= size.y && size.x >= size.z) {
    const dvec3 d = direction / size.x;
    return d.x > 0 ? lookUp(faces[kRight], -d.z, d.y) : lookUp(faces[kLeft], d.z, d.y);
  }
  if (size.y >= size.z) {
    const dvec3 d = direction / size.y;
    return d.y > 0 ? lookUp(faces[kTop], -d.x, -d.z) : lookUp(faces[kBottom], -d.x, d.z);
  }
  const dvec3 d = direction / size.z;
  return d.z > 0 ? lookUp(faces[kFront], -d.x, d.y) : lookUp(faces[kBack], d.x, d.y);
}

dvec3 Background::lookUp(const scene::SkyFace& face, double sc, double tc) const {
  const double s = (sc + 1) / 2 * face.width - 0.5;
  const double t = (1 - tc) / 2 * face.height - 0.5;
  const int column = static_cast<int>(std::floor(s));
  const int row = static_cast<int>(std::floor(t));
  const dvec3 above = glm::mix(texel(face, column, row), texel(face, column + 1, row), s - column);
  const dvec3 below = glm::mix(texel(face, column, row + 1), texel(face, column + 1, row + 1), s - column);
  return glm::mix(above, below, t - row);
}

dvec3 Background::texel(const scene::SkyFace& face, int column, int row) const {
  const auto x = static_cast<std::size_t>(std::clamp(column, 0, static_cast<int>(face.width) - 1));
  const auto y = static_cast<std::size_t>(std::clamp(row, 0, static_cast<int>(face.height) - 1));
  const std::uint8_t* rgb = &face.rgb[3 * (y * face.width + x)];
  return {linear_[rgb[0]], linear_[rgb[1]], linear_[rgb[2]]};
}

}  // namespace candela::reference
