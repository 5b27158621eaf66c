// `l`, `al`, `la` and `light`: point lights and area lights.
#include <fmt/format.h>

#include <cmath>

#include "host/base/quote.h"
#include "host/formats/loading/scene_builder.h"
#include "host/formats/nff/nff_material.h"
#include "host/formats/nff/parser.h"
#include "host/formats/nff/statements.h"

namespace candela::scene {
namespace {

constexpr glm::vec3 kWhite{1, 1, 1};

glm::vec3 readColour(Parser& parser) {
  const Position position = parser.in.here();
  const glm::vec3 colour = parser.in.vector("the light's colour");
  parser.requireNonNegative("the light's colour", colour, position);
  return colour;
}

/// Returns the material of area lights of a colour, which they share.
std::uint32_t lampMaterial(Parser& parser, const glm::vec3& colour) {
  const auto next = static_cast<std::uint32_t>(parser.scene.materials.size());
  const auto [found, isNew] = parser.lampMaterials.try_emplace({colour.x, colour.y, colour.z}, next);
  if (isNew) parser.scene.materials.push_back(fromNff({.diffuse = {0, 0, 0}, .emission = colour}));
  return found->second;
}

/// Adds a black parallelogram whose radiance is the colour.
void addAreaLight(Parser& parser, const glm::vec3& corner, const glm::vec3& u, const glm::vec3& v,
                  const glm::vec3& colour) {
  const glm::vec3 farCorner = corner + u + v;
  if (!std::isfinite(farCorner.x) || !std::isfinite(farCorner.y) || !std::isfinite(farCorner.z)) {
    StatementReader::fail(parser.keyword, "the area light reaches beyond the range of single precision");
  }
  if (glm::cross(glm::dvec3(u), glm::dvec3(v)) == glm::dvec3(0)) {
    StatementReader::fail(parser.keyword, "the area light has no area: its edges are parallel");
  }
  addParallelogram(parser.scene, corner, u, v, lampMaterial(parser, colour));
}

void parsePunctual(Parser& parser) {
  const glm::vec3 position = parser.in.vector("the light's position");
  parser.scene.pointLights.push_back({position, readColour(parser)});
}

void parseQuad(Parser& parser) {
  const glm::vec3 corner = parser.in.vector("the light's corner");
  const glm::vec3 colour = readColour(parser);
  const glm::vec3 u = parser.in.vector("the light's first edge");
  const glm::vec3 v = parser.in.vector("the light's second edge");
  parser.in.numbersOnLine(1);  // the number of samples, which other programs read
  addAreaLight(parser, corner, u, v, colour);
}

}  // namespace

// Reads x y z, then nothing, a colour, or an intensity and a colour.
void parsePointLight(Parser& parser) {
  const glm::vec3 position = parser.in.vector("the light's position");
  const Position colourPosition = parser.in.here();
  std::vector<float> n = parser.in.numbersOnLine(4);
  if (n.size() == 1 || n.size() == 2) {
    parser.deviation("light count", parser.in.here(),
                     fmt::format("a light has 3, 6 or 7 numbers, not {}", n.size() + 3));
    n.clear();
  }
  glm::vec3 colour = kWhite;
  if (n.size() == 3) colour = {n[0], n[1], n[2]};
  if (n.size() == 4) colour = n[0] * glm::vec3(n[1], n[2], n[3]);
  parser.requireNonNegative("the light's colour", colour, colourPosition);
  if (!std::isfinite(colour.x + colour.y + colour.z)) {
    StatementReader::fail(colourPosition,
                          "the light's intensity times its colour is beyond the range of single precision");
  }
  parser.scene.pointLights.push_back({position, colour});
}

void parseAreaLight(Parser& parser) {
  const glm::vec3 corner = parser.in.vector("the light's corner");
  const glm::vec3 u = parser.in.vector("the light's first edge");
  const glm::vec3 v = parser.in.vector("the light's second edge");
  addAreaLight(parser, corner, u, v, readColour(parser));
}

void parseAreaLightWithDefault(Parser& parser) {
  const glm::vec3 corner = parser.in.vector("the light's corner");
  const glm::vec3 u = parser.in.vector("the light's first edge");
  const glm::vec3 v = parser.in.vector("the light's second edge");
  addAreaLight(parser, corner, u, v, parser.in.numberOnLine() ? readColour(parser) : kWhite);
}

void parseNamedLight(Parser& parser) {
  const Token kind = parser.in.word("\"punctual\" or \"quad\"");
  if (kind.text == "punctual") return parsePunctual(parser);
  if (kind.text == "quad") return parseQuad(parser);
  StatementReader::fail(kind.position, fmt::format("expected \"punctual\" or \"quad\", found {}", quote(kind.text)));
}

}  // namespace candela::scene
