// `f`: materials. The number of values on the line determines the dialect.
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "host/formats/nff/nff_material.h"
#include "host/formats/nff/parser.h"
#include "host/formats/nff/statements.h"

namespace candela::scene {
namespace {

constexpr std::size_t kRequired = 8;    ///< numbers that every dialect has
constexpr std::size_t kOptional = 7;    ///< that the longest has beyond them
constexpr std::size_t kMinNumbers = 3;  ///< that --lenient completes: a colour

bool isDialect(std::size_t count) { return count == 8 || count == 9 || (count >= 11 && count <= 15 && count != 13); }

/// In lenient mode: a material that breaks off is completed.
void completeShort(Parser& parser, std::vector<float>& n) {
  if (n.size() >= kRequired) return;
  parser.log.warn("short material", parser.keyword,
                  fmt::format("a material with {} numbers; missing numbers have their defaults", n.size()));
}

std::vector<float> readNumbers(Parser& parser) {
  std::vector<float> n;
  while (n.size() < kRequired) {
    const bool shortened = parser.options.lenient && n.size() >= kMinNumbers && !parser.in.numberFollows();
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

void checkRanges(Parser& parser, const NffMaterial& m) {
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

void warnOfGain(Parser& parser, const NffMaterial& m) {
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
  const NffMaterial material = readNffMaterial(readNumbers(parser));
  checkRanges(parser, material);
  warnOfGain(parser, material);
  parser.material = static_cast<std::uint32_t>(parser.scene.materials.size());
  parser.scene.materials.push_back(fromNff(material));
}

}  // namespace candela::scene
