// The difference that is named first, and its description.
#include <catch2/catch.hpp>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>

#include "host/base/errors.h"
#include "tests/judge/explain/made_traces.h"
#include "tests/trace/reference/default_settings.h"

namespace candela::explain {
namespace {

using Catch::Contains;

// Returns the explanation of a path whose device side is altered by `change`.
Explanation explainChanged(const std::function<void(render::PathTrace&)>& change) {
  render::PathTrace device = madePath();
  change(device);
  return explainMade(device, madePath());
}

std::string firstOf(const Explanation& explanation) {
  if (!explanation.firstDifference) return "none";
  const QuantityIndex& index = *explanation.firstDifference;
  return explanation.stages[index.stage].title + ": " + explanation.at(index).name;
}

std::string firstIn(const std::function<void(render::PathTrace&)>& change) { return firstOf(explainChanged(change)); }

// Returns the artificial path with another weight, as after an amplified error.
render::PathTrace movedBy(double distance) {
  render::PathTrace path = madePath();
  path.vertices[0].scattering->weight *= 1 + distance;
  return path;
}

Explanation explainWithReplicas(const render::PathTrace& device, const std::vector<render::PathTrace>& replicas) {
  return explainReplays(twoSpheres(), render::defaultSettings(), {3, 4, 5}, {device, {}}, {madePath(), {}}, replicas);
}

TEST_CASE("replicas show how much rounding may change a number") {
  const std::vector<render::PathTrace> replicas{movedBy(1e-3), movedBy(-2e-3)};
  const Explanation grown = explainWithReplicas(movedBy(0.01), replicas);
  CHECK_FALSE(grown.firstDifference);
  CHECK_THAT(grown.verdict(), Contains("which is rounding, amplified 3e+04 times"));
  CHECK_THAT(toText(grown), Contains("apart; amplification"));
  CHECK(toJson(grown)["replicas"] == 2);

  const Explanation wrong = explainWithReplicas(movedBy(0.1), replicas);
  REQUIRE(wrong.firstDifference);
  CHECK(wrong.at(*wrong.firstDifference).name == "weight");
  CHECK_THAT(wrong.verdict(), Contains("rounding allows 3e-02") && Contains("Rounding does not explain it."));
  // Without replicas the fixed tolerance applies; with equal replicas an error of a hundred roundings is too large.
  CHECK_FALSE(explainMade(movedBy(1e-5), madePath()).firstDifference);
  CHECK(explainWithReplicas(movedBy(1e-5), {madePath()}).firstDifference);
}

TEST_CASE("a decision that replicas take differently cannot be decided, and says so") {
  render::PathTrace turned = madePath();
  turned.vertices[0].hit->primitive = 1;
  const Explanation explanation = explainWithReplicas(turned, {madePath(), turned});
  REQUIRE(explanation.firstDecision);
  CHECK(explanation.at(*explanation.firstDecision).undecidable);
  CHECK_THAT(explanation.verdict(), Contains("single precision cannot decide it") && !Contains("does not explain"));
  CHECK_THAT(toText(explanation), Contains("undecidable"));
  const Explanation decidable = explainWithReplicas(turned, {madePath()});
  CHECK_FALSE(decidable.at(*decidable.firstDecision).undecidable);
}

}  // namespace

TEST_CASE("equal paths agree, to the bit or within rounding") {
  const Explanation same = explainChanged([](render::PathTrace&) {});
  CHECK_FALSE(same.firstDifference);
  CHECK(same.verdict() == "The two paths agree: no decision differs, and all numbers are bit-identical.");
  const Explanation rounded = explainChanged([](render::PathTrace& path) { path.vertices[0].light->pdf *= 1 + 5e-5; });
  CHECK_FALSE(rounded.firstDifference);
  CHECK_THAT(rounded.verdict(), Contains("no number differs by more than 5.0e-05 (light pdf at vertex 1)"));
}

TEST_CASE("every quantity that differs is named, at its vertex") {
  struct Planted {
    void (*change)(render::PathTrace& p);
    const char* named;
  };
  const Planted all[]{
      {[](render::PathTrace& p) { p.cameraNumbers[1] ^= 1; }, "camera: filter y"},
      {[](render::PathTrace& p) { p.vertices[0].origin.x += 0.01; }, "camera: ray origin"},
      {[](render::PathTrace& p) { p.vertices[0].direction.x += 0.01; }, "camera: ray direction"},
      {[](render::PathTrace& p) { p.vertices[0].numbers[6] ^= 1; }, "vertex 1: roulette u"},
      {[](render::PathTrace& p) { p.vertices[1].throughput.y = 0.9; }, "vertex 2: throughput"},
      {[](render::PathTrace& p) { p.vertices[0].hit->primitive = 1; }, "vertex 1: primitive"},
      {[](render::PathTrace& p) { p.vertices[1].hit = p.vertices[0].hit; }, "vertex 2: primitive"},
      {[](render::PathTrace& p) { p.vertices[0].hit->position.z += 0.01; }, "vertex 1: position"},
      {[](render::PathTrace& p) { p.vertices[0].hit->fromOutside = false; }, "vertex 1: side"},
      {[](render::PathTrace& p) { p.vertices[0].hit->normal.z += 0.01; }, "vertex 1: normal"},
      {[](render::PathTrace& p) { p.vertices[0].hit->shadingNormal.z += 0.01; }, "vertex 1: shading normal"},
      {[](render::PathTrace& p) { p.vertices[0].hit->material = 1; }, "vertex 1: material"},
      {[](render::PathTrace& p) {
         p.vertices[0].emission = render::EmissionTrace{glm::dvec3(5), 1};
       },
       "vertex 1: emission"},
      {[](render::PathTrace& p) { p.vertices[0].light->entry = 1; }, "vertex 1: light"},
      {[](render::PathTrace& p) { p.vertices[0].light.reset(); }, "vertex 1: light"},
      {[](render::PathTrace& p) { p.vertices[0].light->shadow = render::ShadowOutcome::occluded; },
       "vertex 1: shadow ray"},
      {[](render::PathTrace& p) { p.vertices[0].light->primitive = 0; }, "vertex 1: light at"},
      {[](render::PathTrace& p) { p.vertices[0].light->direction.x += 0.01; }, "vertex 1: light direction"},
      {[](render::PathTrace& p) { p.vertices[0].light->distance *= 1.01; }, "vertex 1: light distance"},
      {[](render::PathTrace& p) { p.vertices[0].light->pdf *= 1.01; }, "vertex 1: light pdf"},
      {[](render::PathTrace& p) { p.vertices[0].light->bsdfPdf *= 1.01; }, "vertex 1: light BSDF pdf"},
      {[](render::PathTrace& p) { p.vertices[0].light->weight *= 1.01; }, "vertex 1: light weight"},
      {[](render::PathTrace& p) { p.vertices[0].light->radiance.y *= 1.01; }, "vertex 1: light adds"},
      {[](render::PathTrace& p) { p.vertices[0].scattering->lobe = render::Lobe::glossy; }, "vertex 1: lobe"},
      {[](render::PathTrace& p) { p.vertices[0].scattering.reset(); }, "vertex 1: lobe"},
      {[](render::PathTrace& p) { p.vertices[0].scattering->direction.x += 0.01; }, "vertex 1: direction"},
      {[](render::PathTrace& p) { p.vertices[0].scattering->pdf = 0; }, "vertex 1: pdf"},
      {[](render::PathTrace& p) { p.vertices[0].scattering->weight.x *= 1.01; }, "vertex 1: weight"},
      {[](render::PathTrace& p) { p.vertices[0].roulette->probability *= 1.01; }, "vertex 1: survival"},
      {[](render::PathTrace& p) { p.vertices[0].roulette->survived = false; }, "vertex 1: roulette"},
      {[](render::PathTrace& p) { p.vertices[0].radiance.x *= 1.01; }, "vertex 1: radiance so far"},
      {[](render::PathTrace& p) { p.radiance.x *= 1.01; }, "sample: radiance"},
  };
  for (const auto& [change, named] : all) CHECK(firstIn(change) == named);
}

TEST_CASE("values that are not finite differ from finite values") {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  CHECK(firstIn([](render::PathTrace& p) { p.radiance.x = kNan; }) == "sample: radiance");
  CHECK(firstIn([](render::PathTrace& p) { p.vertices[0].hit->position.x = kNan; }) == "vertex 1: position");
}

TEST_CASE("a number that differs before a decision is reported along with the decision") {
  const Explanation explanation = explainChanged([](render::PathTrace& path) {
    path.vertices[0].scattering->weight *= 1.005;
    path.vertices[0].roulette->survived = false;
    path.vertices.pop_back();
    path.vertexCount = 1;
  });
  CHECK(firstOf(explanation) == "vertex 1: weight");
  const std::string verdict = explanation.verdict();
  CHECK_THAT(verdict, Contains("First difference: vertex 1, weight: 5.0e-03 apart (rounding allows 1e-04); "
                               "0.804 0.804 0.804 on the device, 0.8 0.8 0.8 by the reference."));
  CHECK_THAT(verdict, Contains("First decision that differs: vertex 1, roulette: ended on the device, survived by the "
                               "reference.\nThe sample's radiance is equal."));
}

TEST_CASE("after a decision that differs, only the result is compared") {
  const Explanation explanation = explainChanged([](render::PathTrace& path) {
    path.vertices[0].hit->primitive = 1;
    path.vertices[0].hit->position.x = 7;
    path.radiance *= 2;
  });
  CHECK(explanation.firstDifference == explanation.firstDecision);
  const std::string text = toText(explanation);
  CHECK_THAT(
      text,
      Contains(
          "\n> primitive        1 sphere                            0 sphere                           DIFFERS\n"));
  CHECK_THAT(text, Contains("\n  position         7          -1           0           0          -1           0\n"));
  CHECK_THAT(text, Contains("5.0e-01 DIFFERS\n"));
}

TEST_CASE("a path that continues after the other has ended is shown alone") {
  const Explanation explanation = explainChanged([](render::PathTrace& path) {
    path.vertices[0].scattering.reset();
    path.vertices[0].roulette.reset();
    path.vertices.pop_back();
    path.vertexCount = 1;
  });
  CHECK(firstOf(explanation) == "vertex 1: lobe");
  CHECK_THAT(toText(explanation), Contains("\nvertex 2\n") && Contains("none: the path ends"));
}

TEST_CASE("the text names scene, pixel, tracers and random numbers") {
  const std::string text = toText(explainChanged([](render::PathTrace&) {}));
  CHECK_THAT(text, Contains("made.p3f, pixel 3,4, sample 5, seed 0: a device compared with the reference\n"));
  CHECK_THAT(text, Contains("  random  light choice 0.0625000  light u 0.1250000"));
  CHECK_THAT(text, Contains("primitive 1 sphere"));
  CHECK_THAT(text, Contains("0 diffuse"));
}

TEST_CASE("a path with more vertices than are recorded is marked") {
  const Explanation explanation = explainMade(
      [] {
        render::PathTrace path = madePath();
        path.vertexCount = 100;
        return path;
      }(),
      madePath());
  CHECK_THAT(toText(explanation), Contains("The paths have 100 and 2 vertices; the first 64 are shown.\n"));
}

TEST_CASE("JSON has each quantity by name, and the first that differs") {
  const auto json = toJson(explainChanged([](render::PathTrace& path) { path.vertices[0].light->bsdfPdf = 0.5; }));
  CHECK(json["schema"] == "candela-explain/2");
  CHECK(json["agrees"] == false);
  CHECK(json["x"] == 3);
  CHECK(json["y"] == 4);
  CHECK(json["firstDifference"]["stage"] == "vertex 1");
  CHECK(json["firstDifference"]["quantity"] == "lightBsdfPdf");
  CHECK(json["firstDecision"].is_null());
  const auto& vertex = json["stages"][1];
  CHECK(vertex["stage"] == "vertex 1");
  CHECK(vertex["lightBsdfPdf"]["device"] == 0.5);
  CHECK(vertex["lightBsdfPdf"]["reference"] == 0.25);
  CHECK(vertex["lightBsdfPdf"]["apart"] == 0.5);
  CHECK(vertex["bsdfU"]["device"] == 0.3125);
  CHECK(vertex["position"]["device"] == nlohmann::ordered_json({0.0, -1.0, 0.0}));
  CHECK(json["stages"].back()["radiance"]["agrees"] == true);
}

TEST_CASE("integrators without paths are refused with an alternative") {
  CHECK_NOTHROW(requirePaths(render::Integrator::path));
  CHECK_THROWS_WITH(requirePaths(render::Integrator::whitted), Contains("candela compare SCENE"));
  CHECK_THROWS_AS(requirePaths(render::Integrator::normal), UsageError);
}

}  // namespace candela::explain
