// `s`, `ms` and `c`: spheres, cones and cylinders.
#include "host/formats/loading/scene_builder.h"
#include "host/formats/nff/parser.h"
#include "host/formats/nff/statements.h"

namespace candela::scene {
namespace {

void addCheckedSphere(Parser& parser, const Sphere& sphere, Position radiusPosition) {
  if (sphere.radius == 0) {
    parser.deviation("zero radius", radiusPosition, "a sphere's radius must not be 0");
    return;
  }
  addSphere(parser.scene, sphere, parser.currentMaterial());
}

}  // namespace

void parseSphere(Parser& parser) {
  const glm::vec3 centre = parser.in.vector("the centre");
  const float radius = parser.in.number("the radius");
  addCheckedSphere(parser, {centre, radius}, parser.in.lastNumber());
}

void parseMovingSphere(Parser& parser) {
  const glm::vec3 centre = parser.in.vector("the first centre");
  parser.in.vector("the second centre");
  const float radius = parser.in.number("the radius");
  const Position radiusPosition = parser.in.lastNumber();
  parser.in.numbersOnLine(2);
  parser.log.warn("motion", parser.keyword, "motion is not traced: the sphere stays at its first centre");
  addCheckedSphere(parser, {centre, radius}, radiusPosition);
}

void parseCone(Parser& parser) {
  const glm::vec3 base = parser.in.vector("the base");
  const float baseRadius = parser.in.number("the radius at the base");
  parser.requireNonNegative("the radius at the base", baseRadius, parser.in.lastNumber());
  const glm::vec3 apex = parser.in.vector("the apex");
  const float apexRadius = parser.in.number("the radius at the apex");
  parser.requireNonNegative("the radius at the apex", apexRadius, parser.in.lastNumber());
  if (base == apex) StatementReader::fail(parser.keyword, "the cone's base and apex are the same point");
  if (baseRadius == 0 && apexRadius == 0) StatementReader::fail(parser.keyword, "both radii of the cone are 0");
  addCone(parser.scene, {base, baseRadius, apex, apexRadius}, parser.currentMaterial());
}

}  // namespace candela::scene
