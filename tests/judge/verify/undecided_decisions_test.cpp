// The first decision that rounding changes is named with its surfaces, for paths made up by hand.
#include "host/judge/verify/undecided_decisions.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

namespace candela::verify {
namespace {

using Names = std::vector<std::string>;

// Three objects: a floor of two primitives, a rug and a lamp.
scene::Scene namedScene() {
  scene::Scene scene;
  scene.primitives.append({scene::PrimitiveKind::sphere, 0, 0}, 4);
  scene.objectStarts = {0, 2, 3};
  scene.objectNames = {"Floor", "Rug", "Lamp"};
  return scene;
}

render::VertexTrace hitOn(std::uint32_t primitive) {
  render::VertexTrace vertex;
  vertex.hit.emplace();
  vertex.hit->primitive = primitive;
  return vertex;
}

render::PathTrace pathOf(std::vector<render::VertexTrace> vertices) {
  render::PathTrace path;
  path.vertexCount = static_cast<std::uint32_t>(vertices.size());
  path.vertices = std::move(vertices);
  return path;
}

UndecidedDecision first(const std::vector<render::VertexTrace>& exact,
                        const std::vector<render::VertexTrace>& replica) {
  return firstUndecided(pathOf(exact), pathOf(replica), 1, namedScene());
}

TEST_CASE("a tie of two surfaces is named with both, in one order") {
  for (const bool isSwapped : {false, true}) {
    const UndecidedDecision tie = first({hitOn(isSwapped ? 2 : 1)}, {hitOn(isSwapped ? 1 : 2)});
    CHECK(tie.kind == "primitive");
    CHECK(tie.surfaces == Names{"Floor", "Rug"});
    CHECK(tie.text == "a camera ray hits Floor or Rug");
  }
  CHECK(first({hitOn(0)}, {hitOn(1)}).text == "a camera ray hits one primitive of Floor or another");
}

TEST_CASE("a ray that leaves a surface names it, and what it hits or not") {
  const UndecidedDecision escape = first({hitOn(0), {}}, {hitOn(0), hitOn(2)});
  CHECK(escape.text == "a ray from Floor hits Rug or nothing");
  CHECK(escape.surfaces == Names{"Floor", "Rug"});
  const UndecidedDecision self = first({hitOn(0), {}}, {hitOn(0), hitOn(1)});
  CHECK(self.surfaces == Names{"Floor"});
}

TEST_CASE("decisions at one surface are named in the order in which a path makes them") {
  render::VertexTrace vertex = hitOn(2);
  vertex.light.emplace();
  vertex.light->shadow = render::ShadowOutcome::visible;
  vertex.scattering.emplace();
  vertex.scattering->lobe = render::Lobe::diffuse;
  vertex.roulette.emplace();
  const auto kindOf = [&](const auto& change) {
    render::VertexTrace replica = vertex;
    change(replica);
    const UndecidedDecision decision = first({vertex}, {replica});
    CHECK(decision.surfaces == Names{"Rug"});
    return decision.kind;
  };
  CHECK(kindOf([](auto& v) { v.hit->fromOutside = false; }) == "side");
  CHECK(kindOf([](auto& v) { v.light->entry = 1; }) == "light");
  CHECK(kindOf([](auto& v) { v.light->shadow = render::ShadowOutcome::occluded; }) == "shadow");
  CHECK(kindOf([](auto& v) { v.scattering->lobe = render::Lobe::mirror; }) == "lobe");
  CHECK(kindOf([](auto& v) { v.roulette->survived = false; }) == "roulette");
  CHECK(kindOf([](auto&) {}) == "other");
}

TEST_CASE("the most important kinds of decisions are listed with their fraction of the pixels") {
  UndecidedDecisions decisions;
  decisions.undecidable = 1000;
  decisions.examined = 200;
  decisions.kinds = {{"primitive", {"Floor", "Rug"}, "a camera ray hits Floor or Rug", 150, 3.0},
                     {"lobe", {"Lamp"}, "the lobe that is sampled at Lamp", 50, 0.5}};
  CHECK(decisions.lines() == Names{"undecidable in 75 % of them: a camera ray hits Floor or Rug",
                                   "undecidable in 25 % of them: the lobe that is sampled at Lamp"});
  CHECK(decisions.json()[0]["surfaces"] == Names{"Floor", "Rug"});
  CHECK(decisions.json()[0]["pixelFraction"] == 0.75);
}

}  // namespace
}  // namespace candela::verify
