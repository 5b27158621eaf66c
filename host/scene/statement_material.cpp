// `f`: materials. How many numbers the line has tells the dialect.
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "host/scene/parser.h"
#include "host/scene/statements.h"

namespace candela::scene {
namespace {

constexpr std::size_t kRequired = 8;  ///< numbers that every dialect has
constexpr std::size_t kOptional = 7;  ///< that the longest has beyond them
constexpr std::size_t kFewest = 3;    ///< that --lenient completes: a colour

bool inUnitRange(float x) { return x >= 0 && x <= 1; }

/// Eleven numbers are P3F, unless only NFF with emission fits.
bool isNffWithEmission(const std::vector<float>& n) { return n[5] > 1 || !inUnitRange(n[7]) || !inUnitRange(n[9]); }

glm::vec3 tripleAt(const std::vector<float>& n, std::size_t i) { return {n[i], n[i + 1], n[i + 2]}; }

/// r g b Kd Ks Shine T ior, as far as given.
Material readNff(const std::vector<float>& n) {
  Material m;
  m.diffuse = tripleAt(n, 0);
  float* const rest[] = {&m.kd, &m.ks, &m.shine, &m.t, &m.ior};
  for (std::size_t i = 3; i < std::min(n.size(), kRequired); ++i) *rest[i - 3] = n[i];
  return m;
}

/// r g b Kd r g b Ks Shine T ior
Material readP3f(const std::vector<float>& n) {
  Material m;
  m.diffuse = tripleAt(n, 0);
  m.kd = n[3];
  m.specular = tripleAt(n, 4);
  m.ks = n[7];
  m.shine = n[8];
  m.t = n[9];
  m.ior = n[10];
  return m;
}

/// `n` has one of the counts that name a dialect, or fewer than 8.
Material interpret(const std::vector<float>& n) {
  const std::size_t count = n.size();
  if (count == 11 && isNffWithEmission(n)) {
    Material m = readNff(n);
    m.emission = tripleAt(n, 8);
    return m;
  }
  Material m = count < 11 ? readNff(n) : readP3f(n);
  if (count == 9) m.ka = n[8];
  if (count == 12 || count == 15) m.roughness = n[11];
  if (count >= 14) m.emission = tripleAt(n, count - 3);
  return m;
}

bool isDialect(std::size_t count) { return count == 8 || count == 9 || (count >= 11 && count <= 15 && count != 13); }

/// In lenient mode: a material that breaks off is completed.
void completeShort(Parser& parser, std::vector<float>& n) {
  if (n.size() >= kRequired) return;
  parser.log.warn("short material", parser.keyword,
                  fmt::format("a material with {} numbers; what is missing has its default", n.size()));
}

std::vector<float> readNumbers(Parser& parser) {
  std::vector<float> n;
  while (n.size() < kRequired) {
    const bool shortened = parser.options.lenient && n.size() >= kFewest && !parser.in.numberFollows();
    if (shortened) break;
    n.push_back(parser.in.number("at least 8 numbers"));
  }
  completeShort(parser, n);
  if (n.size() < kRequired) return n;
  const std::vector<float> more = parser.in.numbersOnLine(kOptional);
  n.insert(n.end(), more.begin(), more.end());
  if (isDialect(n.size())) return n;
  parser.deviation("material count", parser.in.here(),
                   fmt::format("a material has 8, 9, 11, 12, 14 or 15 numbers, not {}", n.size()));
  n.pop_back();  // 10 and 13: the dialect before
  return n;
}

void checkRanges(Parser& parser, const Material& m) {
  const Position at = parser.keyword;
  parser.requireNonNegative("the diffuse colour", m.diffuse, at);
  parser.requireNonNegative("Kd", m.kd, at);
  parser.requireNonNegative("the specular colour", m.specular, at);
  parser.requireNonNegative("Ks", m.ks, at);
  parser.requireNonNegative("Shine", m.shine, at);
  parser.requireNonNegative("T", m.t, at);
  parser.requireNonNegative("ior", m.ior, at);
  parser.requireNonNegative("Ka", m.ka, at);
  parser.requireNonNegative("the roughness", m.roughness, at);
  parser.requireNonNegative("the emission", m.emission, at);
}

void warnOfGain(Parser& parser, const Material& m) {
  constexpr float kRounding = 1e-6f;  // of a sum like .1 + .9
  const bool mixture = m.kd != 1 && m.ks != 1;
  const float sum = m.kd + m.ks + m.t;
  if (mixture && sum > 1 + kRounding) {
    parser.log.warn("energy gain", parser.keyword,
                    fmt::format("Kd + Ks + T = {:g}; the path tracer scales them to sum 1", sum));
  }
  const float brightest = std::max({m.diffuse.x, m.diffuse.y, m.diffuse.z});
  if (brightest > 1)
    parser.log.warn("bright colour", parser.keyword, "a colour above 1 reflects more than it receives");
}

}  // namespace

void parseMaterial(Parser& parser) {
  const Material material = interpret(readNumbers(parser));
  checkRanges(parser, material);
  warnOfGain(parser, material);
  parser.material = static_cast<std::uint32_t>(parser.scene.materials.size());
  parser.scene.materials.push_back(material);
}

}  // namespace candela::scene
