// The comparison names the decision at which two paths diverge.
#include "host/judge/verify/agreement.h"

#include <catch2/catch.hpp>

using namespace candela;

namespace {

render::PathRecord twoVertices() {
  render::PathRecord record;
  record.vertexCount = 2;
  record.vertices[0] = {.primitive = 3, .lobe = render::Lobe::diffuse, .shadow = render::ShadowOutcome::visible};
  record.vertices[1] = {.primitive = 5, .lobe = render::Lobe::diffuse, .shadow = render::ShadowOutcome::occluded};
  return record;
}

render::RenderResult picture(double first, double second) {
  render::RenderResult result;
  result.film = image::Film(2, 1);
  result.film.addSample(0, 0, glm::dvec3(first), 0);
  result.film.addSample(1, 0, glm::dvec3(second), 0);
  result.paths.assign(2, twoVertices());
  return result;
}

}  // namespace

TEST_CASE("the first decision that differs is reported as the cause") {
  const render::PathRecord record = twoVertices();
  render::PathRecord other = record;
  CHECK(verify::causeOf(record, other) == verify::Cause::rounding);
  other.vertices[0].visibleLights = 4;
  CHECK(verify::causeOf(record, other) == verify::Cause::shadow);
  other = record;
  other.vertices[1].survivedRoulette = false;
  CHECK(verify::causeOf(record, other) == verify::Cause::roulette);
  other.vertices[1].lobe = render::Lobe::glossy;
  CHECK(verify::causeOf(record, other) == verify::Cause::lobe);
  other.vertices[1].shadow = render::ShadowOutcome::visible;
  CHECK(verify::causeOf(record, other) == verify::Cause::shadow);
  other.vertices[0].primitive = 4;
  CHECK(verify::causeOf(record, other) == verify::Cause::primitive);
}

TEST_CASE("pixels that differ are counted among all pixels and among lit ones") {
  render::RenderResult device = picture(0.5, 0);
  const render::RenderResult reference = picture(0.5001, 0);
  device.paths[0].vertices[0].primitive = 9;
  const verify::PixelAgreement result = verify::comparePixels(device, reference);
  CHECK(result.pixels == 2);
  CHECK(result.equal == 1);
  CHECK(result.lit == 1);
  CHECK(result.litEqual == 0);
  CHECK(result.causes[static_cast<std::size_t>(verify::Cause::primitive)] == 1);
  CHECK(result.worst == Approx(1e-4));
  CHECK_FALSE(result.decisions.isPossible);
}

TEST_CASE("channels within the tolerance are equal") {
  CHECK(verify::comparePixels(picture(1, 0), picture(1.00009, 0)).litEqualFraction() == 1);
  CHECK(verify::comparePixels(picture(0, 0), picture(0x1p-27, 0)).litEqualFraction() == 1);
}
