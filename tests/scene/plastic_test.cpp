// The tables of plastic: docs/light-transport.md section 5.14.
#include "host/scene/plastic.h"

#include <catch2/catch.hpp>
#include <cmath>

using namespace candela::scene;

namespace {

constexpr float kIor = 1.49f / 1.000277f;

float roughnessOf(double alpha) { return static_cast<float>(std::sqrt(alpha)); }

}  // namespace

TEST_CASE("the tables of rough plastic have the values of an independent quadrature over angles") {
  // By tests/trace/proof/plastic_model.py: the reflectance from inside, and transmittances at nodes.
  struct Expected {
    Interface boundary;
    double alpha, internal, at0, at1, at5, at20, at40, at63;
  };
  for (const Expected& e :
       {Expected{Interface::ggx, 0.1, 0.545542, 0.57307, 0.57047, 0.59361, 0.81963, 0.93828, 0.96053},
        Expected{Interface::ggx, 0.3, 0.408790, 0.63586, 0.65088, 0.70107, 0.82621, 0.91760, 0.95417},
        Expected{Interface::beckmann, 0.1, 0.574661, 0.37014, 0.39238, 0.49087, 0.81122, 0.94163, 0.96132},
        Expected{Interface::beckmann, 0.5, 0.435009, 0.76800, 0.77519, 0.80123, 0.87020, 0.92564, 0.95989}}) {
    const Plastic plastic = makePlastic(e.boundary, roughnessOf(e.alpha), kIor);
    CAPTURE(static_cast<int>(e.boundary), e.alpha);
    CHECK(plastic.internalReflectance == Approx(e.internal).margin(1e-4));
    const auto& t = plastic.transmittances;
    CHECK(t[0] == Approx(e.at0).margin(3e-4));
    CHECK(t[1] == Approx(e.at1).margin(3e-4));
    CHECK(t[5] == Approx(e.at5).margin(1e-4));
    CHECK(t[20] == Approx(e.at20).margin(1e-4));
    CHECK(t[40] == Approx(e.at40).margin(1e-4));
    CHECK(t[63] == Approx(e.at63).margin(1e-4));
  }
}

TEST_CASE("a boundary that is hardly rough transmits what Fresnel's equations state") {
  for (const Interface boundary : {Interface::ggx, Interface::beckmann}) {
    const Plastic plastic = makePlastic(boundary, 0, kIor);
    for (std::size_t i = 5; i < Plastic::kNodes; ++i) {
      const double c = static_cast<double>(i) / (Plastic::kNodes - 1), n = kIor;
      const double beyond = std::sqrt(1 - (1 - c * c) / (n * n));
      const double across = (c - n * beyond) / (c + n * beyond), along = (n * c - beyond) / (n * c + beyond);
      CAPTURE(i);
      CHECK(plastic.transmittances[i] == Approx(1 - (across * across + along * along) / 2).margin(1e-4));
    }
  }
}

TEST_CASE("a smooth boundary has the internal reflectance of the published fit and no table") {
  const Plastic plastic = makePlastic(Interface::smooth, 0.5f, kIor, true);
  CHECK(plastic.internalReflectance == Approx(0.590479).margin(1e-6));
  CHECK(plastic.isNonlinear);
  CHECK(plastic.transmittances == decltype(plastic.transmittances){});
}
