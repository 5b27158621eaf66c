// Intersections, compared with values computed by hand and with a second formula.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "host/trace/reference/geometry.h"
#include "host/trace/reference/surface.h"
#include "tests/trace/reference/scene_builder.h"

using namespace candela;
using namespace candela::reference;
using glm::vec3;

namespace {

Ray rayOf(const dvec3& origin, const dvec3& towards) { return {origin, normalize(towards)}; }

struct RandomRays {
  std::mt19937 random{3};
  std::uniform_real_distribution<double> uniform{-1, 1};

  dvec3 point() { return {uniform(random), uniform(random), uniform(random)}; }
  Ray next() {
    const dvec3 origin = 2.0 * point();
    return rayOf(origin, point() - origin);
  }
};

}  // namespace

TEST_CASE("a sphere is hit at the smaller positive root") {
  const SphereShape sphere({vec3(0, 0, 0), 2});
  CHECK(sphere.distance(rayOf({0, 0, 5}, {0, 0, -1}), false) == 3);
  CHECK(sphere.distance(rayOf({0, 0, 0}, {0, 0, -1}), false) == 2);
  CHECK(sphere.distance(rayOf({0, 0, 5}, {0, 0, 1}), false) == kNoHit);
  CHECK(sphere.distance(rayOf({2.1, 0, 5}, {0, 0, -1}), false) == kNoHit);
  CHECK(sphere.normal({0, 2, 0}) == dvec3(0, 1, 0));
}

TEST_CASE("a sphere of negative radius is hit only from inside") {
  const SphereShape sphere({vec3(0, 0, 0), -2});
  CHECK(sphere.distance(rayOf({0, 0, 5}, {0, 0, -1}), false) == 7);
  CHECK(sphere.distance(rayOf({0, 0, 1}, {0, 0, -1}), false) == 3);
  CHECK(sphere.normal({0, 2, 0}) == dvec3(0, -1, 0));
}

TEST_CASE("a ray that starts on a sphere can only hit it at the other root") {
  const SphereShape sphere({vec3(0, 0, 0), 2});
  CHECK(sphere.distance(rayOf({0, 0, 2}, {0, 0, 1}), true) == kNoHit);
  CHECK(sphere.distance(rayOf({0, 0, 2}, {0, 0, -1}), true) == 4);
  CHECK(sphere.distance(rayOf({0, 0, 2.0001}, {1, 0, -1}), true) == Approx(2.0001 * std::sqrt(2)));
}

TEST_CASE("a ray that starts outward on a sphere of radius 100,000 never hits it") {
  const SphereShape wall({vec3(50, -1e5f, 81.6f), 1e5f});
  RandomRays rays;
  for (int i = 0; i < 1000; ++i) {
    const Ray down = rayOf(dvec3(50, 40, 81.6) + 30.0 * rays.point(), rays.point() - dvec3(0, 2, 0));
    const double t = wall.distance(down, false);
    REQUIRE(t < 200);
    const dvec3 position = down.at(t);
    CHECK(length(position - wall.centre) == Approx(1e5).epsilon(1e-14));
    const dvec3 normal = wall.normal(position);
    dvec3 outward = rays.point();
    if (dot(outward, normal) < 0) outward = -outward;
    CHECK(wall.distance({position, normalize(outward)}, true) == kNoHit);
  }
}

TEST_CASE("a triangle is hit inside and on its edges") {
  const TriangleShape triangle(scene::Triangle{{vec3(0, 0, 0), vec3(1, 0, 0), vec3(0, 1, 0)}});
  const auto down = [&](double x, double y) { return triangle.distance(rayOf({x, y, 3}, {0, 0, -1})); };
  CHECK(down(0.25, 0.25) == 3);
  CHECK(down(0, 0) == 3);
  CHECK(down(0.5, 0.5) == 3);
  CHECK(down(0.5, 0) == 3);
  CHECK(down(1, 0) == 3);
  CHECK(down(0.51, 0.5) == kNoHit);
  CHECK(down(-0.01, 0.5) == kNoHit);
  CHECK(triangle.distance(rayOf({0.25, 0.25, -3}, {0, 0, -1})) == kNoHit);
  CHECK(triangle.distance(rayOf({0.25, 0.25, -3}, {0, 0, 1})) == 3);
  CHECK(triangle.distance(rayOf({0.25, -1, 0}, {0, 1, 0})) == kNoHit);
  CHECK(triangle.areaNormal() == dvec3(0, 0, 1));
  const dvec2 b = triangle.barycentrics(rayOf({0.25, 0.5, 3}, {0, 0, -1}));
  CHECK(b.x == Approx(0.25));
  CHECK(b.y == Approx(0.5));
}

TEST_CASE("a ray that starts on another primitive in a triangle's or plane's plane does not hit it") {
  const TriangleShape triangle(scene::Triangle{{vec3(0, 0, 4), vec3(2, 0, 4), vec3(0, 2, 4)}});
  const PlaneShape plane(scene::Plane{{vec3(0, 0, 4), vec3(2, 0, 4), vec3(0, 2, 4)}});
  const auto start = [](double below, std::uint32_t originPrimitive) {
    Ray ray = rayOf({0.5, 0.5, 4 - below}, {0, 0, 1});
    ray.originPrimitive = originPrimitive;
    return ray;
  };
  for (const double rounding : {1e-15, 1e-13}) {
    CHECK(triangle.distance(start(rounding, 7)) == kNoHit);
    CHECK(plane.distance(start(rounding, 7)) == kNoHit);
    CHECK(triangle.distance(start(rounding, kNoPrimitive)) < 1e-12);
  }
  CHECK(triangle.distance(start(1e-9, 7)) == Approx(1e-9).epsilon(1e-5));
  CHECK(plane.distance(start(1e-9, 7)) == Approx(1e-9).epsilon(1e-5));
}

TEST_CASE("the plane in which a ray starts is as uncertain as the larger coordinates, of the ray or of the plane") {
  const auto check = [](const vec3& first, const vec3& second, const vec3& third, const dvec2& at) {
    const TriangleShape triangle(scene::Triangle{{first, second, third}});
    const PlaneShape plane(scene::Plane{{first, second, third}});
    const auto start = [&](double below) {
      Ray ray = rayOf({at.x, at.y, -below}, {0, 0, 1});
      ray.originPrimitive = 7;
      return ray;
    };
    CHECK(triangle.distance(start(1e-8)) == kNoHit);
    CHECK(plane.distance(start(1e-8)) == kNoHit);
    CHECK(triangle.distance(start(1e-5)) == Approx(1e-5));
    CHECK(plane.distance(start(1e-5)) == Approx(1e-5));
  };
  check({0, 0, 0}, {1e6f, 0, 0}, {0, 1e6f, 0}, {4e5, 4e5});
  check({1e6f, 1e6f, 0}, {-1e6f, 1e6f, 0}, {0, -1e6f, 0}, {0.125, 0.125});
}

TEST_CASE("a reflection on the common edge of two triangles does not hit the second one") {
  const TriangleShape first(scene::Triangle{{vec3(-9, -9, 0), vec3(9, -9, 0), vec3(9, 9, 0)}}),
      second(scene::Triangle{{vec3(-9, -9, 0), vec3(9, 9, 0), vec3(-9, 9, 0)}});
  RandomRays rays;
  int below = 0;
  for (int i = 0; i < 1000; ++i) {
    const double onEdge = 9 * rays.uniform(rays.random);
    const Ray down = rayOf({0, 0, 3}, dvec3(onEdge, onEdge, -3));
    const dvec3 position = down.at(first.distance(down));
    below += position.z < 0 ? 1 : 0;
    const Ray reflected{position, {down.direction.x, down.direction.y, -down.direction.z}, 0};
    REQUIRE(second.distance(reflected) == kNoHit);
  }
  CHECK(below > 0);  // where rounding would let it be hit
}

TEST_CASE("the hits of a triangle agree with its plane and the sides of its edges") {
  RandomRays rays;
  int hits = 0;
  for (int i = 0; i < 3000; ++i) {
    const vec3 p0(rays.point()), p1(rays.point()), p2(rays.point());
    const TriangleShape triangle(scene::Triangle{{p0, p1, p2}});
    const Ray ray = rays.next();
    const dvec3 n = cross(dvec3(p1) - dvec3(p0), dvec3(p2) - dvec3(p0));
    const double t = dot(dvec3(p0) - ray.origin, n) / dot(ray.direction, n);
    const dvec3 x = ray.at(t);
    const auto side = [&](const vec3& a, const vec3& b) { return dot(cross(dvec3(b) - dvec3(a), x - dvec3(a)), n); };
    const double inside = std::min({side(p0, p1), side(p1, p2), side(p2, p0)});
    if (std::abs(inside) < 1e-12) continue;  // too near to an edge to decide
    const double expected = t > 0 && inside > 0 ? t : kNoHit;
    CHECK(triangle.distance(ray) == (expected == kNoHit ? Approx(kNoHit) : Approx(expected).epsilon(1e-9)));
    hits += expected < kNoHit;
  }
  CHECK(hits > 100);
}

TEST_CASE("a ray hits a box where it enters, or exits if it starts inside") {
  const BoxShape box({vec3(-1, -1, -1), vec3(1, 2, 3)});
  const Ray fromAbove = rayOf({0, 0, 5}, {0, 0, -1});
  CHECK(box.distance(fromAbove, false) == 2);
  CHECK(box.normal(fromAbove, box.distance(fromAbove, false), false) == dvec3(0, 0, 1));
  const Ray fromInside = rayOf({0, 0, 0}, {1, 0, 0});
  CHECK(box.distance(fromInside, false) == 1);
  CHECK(box.normal(fromInside, box.distance(fromInside, false), false) == dvec3(1, 0, 0));
  CHECK(box.distance(rayOf({0, 5, 0}, {0, 1, 0}), false) == kNoHit);
  CHECK(box.distance(rayOf({0, 5, 0}, {1, -1, 0}), false) == kNoHit);
  const Ray slanted = rayOf({-4, -4, 0}, {3, 4, 0});  // enters x = -1 at y = 0
  CHECK(box.distance(slanted, false) == Approx(5));
  CHECK(box.normal(slanted, box.distance(slanted, false), false) == dvec3(-1, 0, 0));
}

TEST_CASE("a ray that starts on a box hits only the opposite side, and only if it goes inside") {
  const BoxShape box({vec3(-1, -1, -1), vec3(1, 1, 1)});
  Ray ray = rayOf({0, 0, 1}, {0, 0, -1});
  ray.originNormal = {0, 0, 1};
  CHECK(box.distance(ray, true) == 2);
  CHECK(box.normal(ray, box.distance(ray, true), true) == dvec3(0, 0, -1));
  ray.direction = {0, 0, 1};
  CHECK(box.distance(ray, true) == kNoHit);
}

TEST_CASE("a box without thickness is hit on the side of the ray's origin") {
  const BoxShape flat({vec3(-1, -1, 0), vec3(1, 1, 0)});
  const Ray down = rayOf({0, 0, 5}, {0, 0, -1}), up = rayOf({0, 0, -5}, {0, 0, 1});
  CHECK(flat.distance(down, false) == 5);
  CHECK(flat.normal(down, flat.distance(down, false), false) == dvec3(0, 0, 1));
  CHECK(flat.normal(up, flat.distance(up, false), false) == dvec3(0, 0, -1));
}

TEST_CASE("a cylinder has a lateral surface but no caps") {
  const ConeShape cylinder({vec3(0, 0, 0), 1, vec3(0, 0, 4), 1});
  CHECK(cylinder.distance(rayOf({5, 0, 2}, {-1, 0, 0}), false) == 4);
  CHECK(cylinder.distance(rayOf({0, 0, 2}, {-1, 0, 0}), false) == 1);
  CHECK(cylinder.distance(rayOf({5, 0, 4.1}, {-1, 0, 0}), false) == kNoHit);
  CHECK(cylinder.distance(rayOf({0.5, 0, 9}, {0, 0, -1}), false) == kNoHit);
  // Through the open end onto the inside.
  CHECK(cylinder.distance(rayOf({-1.5, 0, 5}, {1, 0, -1}), false) == Approx(2.5 * std::sqrt(2)));
  CHECK(cylinder.normal({0, 1, 3}) == dvec3(0, 1, 0));
}

TEST_CASE("a cone is hit only on its lateral surface, not on its mirror image beyond the apex") {
  const ConeShape cone({vec3(0, 0, 0), 2, vec3(0, 0, 2), 0});
  CHECK(cone.distance(rayOf({5, 0, 1}, {-1, 0, 0}), false) == Approx(4));
  CHECK(cone.distance(rayOf({5, 0, 3}, {-1, 0, 0}), false) == kNoHit);
  CHECK(cone.distance(rayOf({5, 0, -1}, {-1, 0, 0}), false) == kNoHit);
  CHECK(length(cone.normal({1, 0, 1}) - normalize(dvec3(1, 0, 1))) < 1e-15);
  // Parallel to its side the quadratic has one root.
  CHECK(cone.distance(rayOf({-3, 0, 0.5}, {1, 0, 1}), false) == kNoHit);
  CHECK(cone.distance(rayOf({-1, 0, 0}, {1, 0, 1}), false) == Approx(1.5 * std::sqrt(2)));
  CHECK(cone.distance(rayOf({0, 0, 0}, {1, 0, 1}), false) == Approx(std::sqrt(2)));
}

TEST_CASE("a ray that starts on a cone can only hit it at the other root") {
  const ConeShape cylinder({vec3(0, 0, 0), 1, vec3(0, 0, 4), 1});
  CHECK(cylinder.distance(rayOf({1, 0, 2}, {-1, 0, 0}), true) == Approx(2));
  CHECK(cylinder.distance(rayOf({1, 0, 2}, {1, 0, 0}), true) == kNoHit);
  CHECK(cylinder.distance(rayOf({1, 0, 2}, {-1, 0, 2}), true) == kNoHit);  // out through the open end
}

TEST_CASE("a cone's hits are on its surface, and none is closer") {
  RandomRays rays;
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    const scene::Cone cone{vec3(rays.point()), float(std::abs(rays.uniform(rays.random))), vec3(rays.point()),
                           float(std::abs(rays.uniform(rays.random)))};
    const ConeShape shape(cone);
    const Ray ray = rays.next();
    // The sign of distance from the axis less radius, along the ray, restricted to the cone's height.
    const auto implicit = [&](double t) {
      const dvec3 p = ray.at(t) - dvec3(cone.base);
      const dvec3 axis = dvec3(cone.apex) - dvec3(cone.base);
      const double share = dot(p, axis) / dot(axis, axis);
      const double radius = cone.baseRadius + share * (double{cone.apexRadius} - cone.baseRadius);
      return dvec2(length(p - share * axis) - radius, share);
    };
    const double t = shape.distance(ray, false);
    if (t < kNoHit) {
      ++hits;
      CHECK(implicit(t).x == Approx(0).margin(1e-7));
      CHECK(implicit(t).y >= -1e-9);
      CHECK(implicit(t).y <= 1 + 1e-9);
    }
    // Marching must not cross the surface before.
    dvec2 previous = implicit(0);
    for (double s = 0.01; s < std::min(t, 5.0) - 0.01; s += 0.01) {
      const dvec2 now = implicit(s);
      const bool inRange = std::min(previous.y, now.y) > 0 && std::max(previous.y, now.y) < 1;
      if (inRange && (previous.x > 0) != (now.x > 0)) FAIL("crossed at " << s << " before the hit at " << t);
      previous = now;
    }
  }
  CHECK(hits > 100);
}

TEST_CASE("a plane is hit in front of the ray's origin, from both sides") {
  const PlaneShape plane({vec3(0, 0, 1), vec3(1, 0, 1), vec3(0, 1, 1)});
  CHECK(plane.unitNormal == dvec3(0, 0, 1));
  CHECK(plane.distance(rayOf({7, 7, 3}, {0, 0, -1})) == 2);
  CHECK(plane.distance(rayOf({7, 7, -3}, {0, 0, 1})) == 4);
  CHECK(plane.distance(rayOf({7, 7, 3}, {0, 0, 1})) == kNoHit);
  CHECK(plane.distance(rayOf({7, 7, 3}, {1, 0, 0})) == kNoHit);
}

TEST_CASE("the shading normal of a patch is interpolated, or is the geometric normal if it would not face the ray") {
  test::SceneBuilder b;
  b.material(test::diffuseMaterial(vec3(1)));
  const vec3 tilted = normalize(vec3(0, -2, 1));
  b.patch({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {{{0, 0, 1}, {1, 0, 0}, tilted}});
  const auto normalSeen = [&](const Ray& ray) { return surfaceAt(b.scene, ray, {1, 0}).shadingNormal; };

  const dvec3 between = normalSeen({{0.5, 0, 1}, {0, 0, -1}});
  CHECK(length(between - normalize(dvec3(1, 0, 1))) < 1e-12);
  CHECK(length(normalSeen({{0.5, 0, -1}, {0, 0, 1}}) + normalize(dvec3(1, 0, 1))) < 1e-12);
  // At (0, 1) the normal (0, -2, 1) points away from a ray that comes from y > 0 near the horizon.
  const Ray grazing{{0, 1 + 0.9, 0.5}, normalize(dvec3(0, -0.9, -0.5))};
  const double t = std::sqrt(0.81 + 0.25);
  CHECK(surfaceAt(b.scene, grazing, {t, 0}).shadingNormal == dvec3(0, 0, 1));
}

TEST_CASE("a hit records the side from which the surface is seen") {
  test::SceneBuilder b;
  b.material(test::diffuseMaterial(vec3(1))).sphere({0, 0, 0}, 1);
  const Surface outside = surfaceAt(b.scene, {{0, 0, 3}, {0, 0, -1}}, {2, 0});
  CHECK(outside.fromOutside);
  CHECK(outside.facingNormal == dvec3(0, 0, 1));
  const Surface inside = surfaceAt(b.scene, {{0, 0, 0}, {0, 0, 1}}, {1, 0});
  CHECK_FALSE(inside.fromOutside);
  CHECK(inside.outwardNormal == dvec3(0, 0, 1));
  CHECK(inside.facingNormal == dvec3(0, 0, -1));
}
