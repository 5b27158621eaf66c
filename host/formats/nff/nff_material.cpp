// Converts the `f` lines of NFF and P3F to materials.
#include "host/formats/nff/nff_material.h"

#include <algorithm>

namespace candela::scene {
namespace {

constexpr std::size_t kCommonNumbers = 8;  ///< numbers that every dialect has

bool inUnitRange(float x) { return x >= 0 && x <= 1; }

/// Eleven numbers are P3F, unless only NFF with emission fits.
bool isNffWithEmission(std::span<const float> n) { return n[5] > 1 || !inUnitRange(n[7]) || !inUnitRange(n[9]); }

glm::vec3 tripleAt(std::span<const float> n, std::size_t i) { return {n[i], n[i + 1], n[i + 2]}; }

/// The numbers are r g b Kd Ks Shine T ior, as far as given.
NffMaterial readNff(std::span<const float> n) {
  NffMaterial m;
  m.diffuse = tripleAt(n, 0);
  float* const rest[] = {&m.kd, &m.ks, &m.shine, &m.t, &m.ior};
  for (std::size_t i = 3; i < std::min(n.size(), kCommonNumbers); ++i) *rest[i - 3] = n[i];
  return m;
}

/// The numbers are r g b Kd r g b Ks Shine T ior.
NffMaterial readP3f(std::span<const float> n) {
  NffMaterial m;
  m.diffuse = tripleAt(n, 0);
  m.kd = n[3];
  m.specular = tripleAt(n, 4);
  m.ks = n[7];
  m.shine = n[8];
  m.t = n[9];
  m.ior = n[10];
  return m;
}

void addMixture(const NffMaterial& line, Material& material) {
  const double sum = double{line.kd} + double{line.ks} + double{line.t};
  const double scale = sum > 1 ? 1 / sum : 1;
  if (line.kd > 0) material.diffuse = DiffuseLobe{line.kd * scale, line.diffuse};
  if (line.ks > 0) material.glossy = GlossyLobe{line.ks * scale, line.specular, line.shine};
  if (line.t > 0 && line.ior > 0) material.dielectric = DielectricLobe{line.t * scale, line.diffuse, line.ior};
}

void addLobes(const NffMaterial& line, Material& material) {
  if (line.kd == 1) {
    material.diffuse = DiffuseLobe{1, line.diffuse};
  } else if (line.ks == 1) {
    material.mirror = MirrorLobe{line.diffuse};
  } else if (line.kd != 0 || line.ks != 0) {
    addMixture(line, material);
  } else if (line.ior > 0) {
    material.dielectric = DielectricLobe{1, line.diffuse, line.ior};
  }
}

WhittedKind whittedKindOf(const NffMaterial& line) {
  if (line.t > 0) return line.ior > 0 ? WhittedKind::glass : WhittedKind::opaque;
  return line.ks > 0 ? WhittedKind::mirror : WhittedKind::opaque;
}

}  // namespace

NffMaterial readNffMaterial(std::span<const float> numbers) {
  const std::size_t count = numbers.size();
  if (count == 11 && isNffWithEmission(numbers)) {
    NffMaterial m = readNff(numbers);
    m.emission = tripleAt(numbers, kCommonNumbers);
    return m;
  }
  NffMaterial m = count < 11 ? readNff(numbers) : readP3f(numbers);
  if (count == 9) m.ka = numbers[8];
  if (count == 12 || count == 15) m.roughness = numbers[11];
  if (count >= 14) m.emission = tripleAt(numbers, count - 3);
  return m;
}

Material fromNff(const NffMaterial& line) {
  Material material;
  addLobes(line, material);
  material.emission = line.emission;
  material.opaque = line.t == 0;
  material.whitted = WhittedMaterial{.kind = whittedKindOf(line),
                                     .diffuse = line.diffuse,
                                     .kd = line.kd,
                                     .ka = line.ka,
                                     .specular = line.specular,
                                     .ks = line.ks,
                                     .shine = line.shine,
                                     .ior = line.ior};
  return material;
}

}  // namespace candela::scene
