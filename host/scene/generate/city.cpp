// city: five buildings, shown many times, along streets with trees and cars.
#include <algorithm>
#include <array>
#include <cmath>

#include "host/scene/generate/city_plan.h"
#include "host/scene/generate/flat_shapes.h"
#include "host/scene/generate/gltf_material.h"
#include "host/scene/generate/gltf_scenes.h"
#include "host/scene/generate/rotation.h"
#include "host/scene/generate/tree_species.h"
#include "host/scene/generate/value_noise.h"

namespace candela::generate {
namespace {

using glm::dvec3;

constexpr std::size_t kPaints = 5;  // of cars

struct Tint {
  dvec3 wall, trim;
};
constexpr std::array<std::array<Tint, kFacadeTints>, kBuildingCount> kTints{{
    {{{{0.36, 0.13, 0.075}, {0.6, 0.54, 0.44}},
      {{0.52, 0.38, 0.2}, {0.66, 0.6, 0.5}},
      {{0.58, 0.44, 0.3}, {0.7, 0.66, 0.56}},
      {{0.3, 0.16, 0.11}, {0.55, 0.5, 0.42}}}},
    {{{{0.56, 0.47, 0.33}, {0.7, 0.66, 0.58}},
      {{0.42, 0.2, 0.12}, {0.58, 0.54, 0.48}},
      {{0.55, 0.43, 0.27}, {0.66, 0.62, 0.55}},
      {{0.45, 0.3, 0.18}, {0.66, 0.62, 0.56}}}},
    {{{{0.5, 0.46, 0.4}, {0.34, 0.32, 0.3}},
      {{0.3, 0.29, 0.28}, {0.5, 0.48, 0.45}},
      {{0.46, 0.34, 0.22}, {0.3, 0.24, 0.18}},
      {{0.6, 0.58, 0.55}, {0.5, 0.5, 0.5}}}},
    {{{{0.55, 0.46, 0.33}, {0.62, 0.55, 0.43}},
      {{0.42, 0.24, 0.15}, {0.56, 0.46, 0.34}},
      {{0.58, 0.55, 0.5}, {0.66, 0.64, 0.6}},
      {{0.36, 0.34, 0.31}, {0.48, 0.46, 0.43}}}},
    {{{{0.2, 0.22, 0.24}, {0.5, 0.52, 0.54}},
      {{0.1, 0.12, 0.13}, {0.24, 0.25, 0.26}},
      {{0.3, 0.32, 0.33}, {0.6, 0.6, 0.6}},
      {{0.16, 0.13, 0.1}, {0.4, 0.32, 0.22}}}},
}};
constexpr std::array<dvec3, kFacadeTints> kTowerGlass{
    {{0.35, 0.45, 0.55}, {0.2, 0.28, 0.34}, {0.4, 0.52, 0.52}, {0.5, 0.42, 0.3}}};
constexpr std::array<dvec3, kPaints> kCarPaint{
    {{0.7, 0.7, 0.7}, {0.06, 0.06, 0.07}, {0.5, 0.03, 0.02}, {0.7, 0.45, 0.03}, {0.05, 0.12, 0.3}}};

std::size_t glassOf(GltfDocument& document, Building building, std::size_t tint) {
  if (building == Building::tower) {
    return document.addMaterial(gltfMaterial({.colour = kTowerGlass[tint], .metalness = 1, .roughness = 0.04}));
  }
  return document.addMaterial(gltfMaterial({.colour = {0.02, 0.025, 0.03}, .roughness = 0.05}));
}

dvec3 roofOf(Building building, std::size_t tint) {
  if (building != Building::house) return dvec3(0.2, 0.19, 0.18) * (0.7 + 0.2 * static_cast<double>(tint));
  return tint % 2 == 0 ? dvec3(0.34, 0.12, 0.06) : dvec3(0.1, 0.105, 0.12);
}

std::size_t addPainted(GltfDocument& document, const dvec3& colour, double roughness) {
  return document.addMaterial(gltfMaterial({.colour = colour, .roughness = roughness}));
}

void addBuildings(GltfDocument& document, const CityPlan& plan) {
  for (std::size_t kind = 0; kind < kBuildingCount; ++kind) {
    const auto building = static_cast<Building>(kind);
    std::array<std::size_t, kBuildingPartCount> shapes{};
    std::ranges::transform(buildingModels()[kind], shapes.begin(),
                           [&](const TriangleMesh& mesh) { return document.addShape(mesh); });
    for (std::size_t tint = 0; tint < kFacadeTints; ++tint) {
      std::vector<MeshInstance> places;
      for (const BuildingPlace& each : plan.buildings) {
        if (each.building == building && each.tint == tint) places.push_back(each.place);
      }
      if (places.empty()) continue;
      const Tint& colours = kTints[kind][tint];
      const MeshPart parts[] = {{shapes[0], addPainted(document, colours.wall, 0.85)},
                                {shapes[1], addPainted(document, colours.trim, 0.7)},
                                {shapes[2], glassOf(document, building, tint)},
                                {shapes[3], addPainted(document, roofOf(building, tint), 0.9)}};
      document.addInstances(document.addMesh(parts), places);
    }
  }
}

template <class Item>
std::vector<Item> everyNth(const std::vector<Item>& items, std::size_t first, std::size_t step) {
  std::vector<Item> chosen;
  for (std::size_t i = first; i < items.size(); i += step) chosen.push_back(items[i]);
  return chosen;
}

void addCars(GltfDocument& document, const std::vector<MeshInstance>& cars) {
  const std::array<TriangleMesh, 2> car = carModel();
  const std::size_t body = document.addShape(car[0]), dark = document.addShape(car[1]);
  const std::size_t black = addPainted(document, dvec3(0.015), 0.15);
  for (std::size_t paint = 0; paint < kPaints; ++paint) {
    const MeshPart parts[] = {{body, addPainted(document, kCarPaint[paint], 0.25)}, {dark, black}};
    document.addInstances(document.addMesh(parts), everyNth(cars, paint, kPaints));
  }
}

constexpr std::array kStreetTints{dvec3(0.13, 0.21, 0.035), dvec3(0.22, 0.26, 0.045), dvec3(0.4, 0.27, 0.05)};

void addStreetTrees(GltfDocument& document, const std::vector<MeshInstance>& trees) {
  const Plant& plant = speciesModels()[static_cast<std::size_t>(Species::maple)];
  const std::size_t bark = document.addShape(plant.bark), leaves = document.addShape(plant.leaves);
  const std::size_t barkMaterial = addPainted(document, {0.12, 0.09, 0.065}, 0.9);
  for (std::size_t tint = 0; tint < kStreetTints.size(); ++tint) {
    GltfDocument::Json material = gltfMaterial({.colour = kStreetTints[tint], .roughness = 0.7});
    material["doubleSided"] = true;
    const MeshPart parts[] = {{bark, barkMaterial}, {leaves, document.addMaterial(material)}};
    document.addInstances(document.addMesh(parts), everyNth(trees, tint, kStreetTints.size()));
  }
}

void addRepeated(GltfDocument& document, const TriangleMesh& mesh, const dvec3& colour,
                 const std::vector<MeshInstance>& places) {
  const MeshPart part{document.addShape(mesh), addPainted(document, colour, 0.9)};
  document.addInstances(document.addMesh({&part, 1}), places);
}

TriangleMesh slab() {
  constexpr double w = CityPlan::kBlockWidth / 2, d = CityPlan::kBlockDepth / 2;
  TriangleMesh mesh;
  appendBox(mesh, {-w, -0.1, -d}, {w, CityPlan::kKerb, d});
  return mesh;
}

TriangleMesh dash() {
  TriangleMesh mesh;
  appendBox(mesh, {-0.09, -0.05, -1.6}, {0.09, 0.012, 1.6});
  return mesh;
}

// The roads of the city as a disc, and around it fields and distant hills.
TriangleMesh surroundings(double radius) {
  constexpr std::uint32_t kAround = 180, kRings = 40;
  TriangleMesh mesh;
  const auto pointAt = [&](std::uint32_t ring, double turn) {
    const double r = ring == 0 ? 0 : radius * std::pow(1 + 9000 / radius, (ring - 1.0) / (kRings - 1));
    const dvec3 flat(r * std::cos(turn), 0, -r * std::sin(turn));
    const double beyond = r - radius;
    const double hill = fractalNoise(flat / 1900.0 + 3.0, 5);
    return flat + dvec3(0, smoothStep(1500, 6000, beyond) * (60 + 900 * hill * hill), 0);
  };
  for (std::uint32_t ring = 0; ring <= kRings; ++ring) {
    for (std::uint32_t i = 0; i < kAround; ++i) {
      const double turn = kTurn * i / kAround;
      const dvec3 at = pointAt(ring, turn);
      const dvec3 around = pointAt(std::max(ring, 1u), turn + 0.01) - pointAt(std::max(ring, 1u), turn - 0.01);
      const dvec3 outwards = pointAt(ring + 1, turn) - pointAt(std::max(ring, 1u) - 1, turn);
      mesh.positions.emplace_back(at);
      mesh.normals.emplace_back(normalize(cross(outwards, around)));
      const double fields = fractalNoise(at / 140.0, 3), haze = 1 - std::exp(-length(at) / 7000);
      const dvec3 field = mix(dvec3(0.06, 0.09, 0.025), dvec3(0.2, 0.17, 0.07), smoothStep(0.35, 0.65, fields));
      mesh.colours.emplace_back(ring <= 1 ? dvec3(0.075, 0.075, 0.08) : mix(field, dvec3(0.36, 0.46, 0.58), haze));
    }
  }
  for (std::uint32_t ring = 0; ring < kRings; ++ring) {
    for (std::uint32_t i = 0; i < kAround; ++i) {
      const std::uint32_t a = ring * kAround + i, b = ring * kAround + (i + 1) % kAround;
      if (ring > 0) mesh.indices.insert(mesh.indices.end(), {a, a + kAround, b});
      mesh.indices.insert(mesh.indices.end(), {b, a + kAround, b + kAround});
    }
  }
  return mesh;
}

}  // namespace

std::uint64_t cityPrimitives(std::uint32_t size) {
  const CityPlan plan = planCity(size);
  std::uint64_t count = surroundings(plan.radius).triangleCount();
  for (const BuildingPlace& each : plan.buildings) {
    for (const TriangleMesh& mesh : buildingModels()[static_cast<std::size_t>(each.building)]) {
      count += mesh.triangleCount();
    }
  }
  const Plant& tree = speciesModels()[static_cast<std::size_t>(Species::maple)];
  const std::array<TriangleMesh, 2> car = carModel();
  return count + plan.trees.size() * (tree.bark.triangleCount() + tree.leaves.triangleCount()) +
         plan.cars.size() * (car[0].triangleCount() + car[1].triangleCount()) +
         plan.blocks.size() * slab().triangleCount() + plan.dashes.size() * dash().triangleCount();
}

void writeCity(NffWriter& out, std::uint32_t size) {
  const CityPlan plan = planCity(size);
  GltfDocument document;
  const std::size_t ground = addPainted(document, dvec3(1), 0.9);
  document.addNode(document.addShape(surroundings(plan.radius)), ground, dvec3(0));
  addBuildings(document, plan);
  addRepeated(document, slab(), {0.3, 0.29, 0.28}, plan.blocks);
  addRepeated(document, dash(), dvec3(0.7), plan.dashes);
  addCars(document, plan.cars);
  addStreetTrees(document, plan.trees);
  document.addCamera({3, 54, 262}, {26, 68, -210}, 42, 16.0 / 9);
  out.text(document.text());
}

}  // namespace candela::generate
