// forest: trees of five species around a lake, each species stored once.
#include "host/scene/generate/forest.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "host/scene/generate/gltf_material.h"
#include "host/scene/generate/gltf_scenes.h"
#include "host/scene/generate/hash_sequence.h"
#include "host/scene/generate/lathe.h"
#include "host/scene/generate/rotation.h"
#include "host/scene/generate/value_noise.h"

namespace candela::generate {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double kCell = 2.4;   // of the grid of candidates for trees, in metres
constexpr int kNeighbours = 3;  // cells to each side that may hold a tree that is too close
constexpr dvec2 kEyePlace{0, 0};
constexpr double kClearRadius = 14;  // around the camera
constexpr double kEyeHeight = 4.5;   // above the ground
constexpr std::uint32_t kTreeSeed = 11, kRockSeed = 12, kTuftSeed = 13;
constexpr std::size_t kRockShapes = 3;
constexpr std::uint32_t kBlades = 46;  // of a tuft of grass

struct Candidate {
  dvec2 place;
  double priority;
  HashSequence random;
};

// Returns the candidate of a cell, anywhere in it.
Candidate candidateOf(std::int32_t column, std::int32_t row) {
  HashSequence random(kTreeSeed, column, row);
  const dvec2 place = kCell * dvec2{column + random.next(), row + random.next()};
  const double priority = random.next();
  return {place, priority, random};
}

// Returns the distance that a tree has from trees of higher priority, in metres: more where the forest is clear.
double spacing(const dvec2& place) { return 2.7 + 3.8 * smoothStep(0.5, 0.72, fractalNoise({place / 65.0, 3.5}, 3)); }

// Returns whether nothing stands in the view of the lake, and the ground bears trees.
bool isWoodland(const LakeValley& valley, const dvec2& place) {
  const double ahead = kEyePlace.y - place.y, aside = place.x - kEyePlace.x;
  const double opening = (aside < 0 ? 0.25 : 0.42) * std::max(ahead, 0.0);  // trees on the left frame the view
  const bool isInView = ahead > -7 && ahead < 120 && std::abs(aside) < 4.5 + opening;
  const double shore = LakeValley::shoreDistance(place);
  if (length(place - kEyePlace) < kClearRadius) return false;
  return shore > 3 && !(isInView && shore < 60 && place.y > -70) && valley.contains(place) && valley.slopeAt(place) < 1;
}

// Keeps candidates without a neighbour of higher priority within their spacing (B. Matern, "Spatial Variation", 1960:
// the second hard-core process).
bool isKept(const LakeValley& valley, const Candidate& candidate, std::int32_t column, std::int32_t row) {
  if (!isWoodland(valley, candidate.place)) return false;
  const double distance = spacing(candidate.place);
  for (int dy = -kNeighbours; dy <= kNeighbours; ++dy) {
    for (int dx = -kNeighbours; dx <= kNeighbours; ++dx) {
      const Candidate other = candidateOf(column + dx, row + dy);
      if (other.priority > candidate.priority && length(other.place - candidate.place) < distance &&
          isWoodland(valley, other.place)) {
        return false;
      }
    }
  }
  return true;
}

// Returns a species: birches near the shore, conifers on the hills, and groups of all.
Species speciesAt(const dvec2& place, double height, HashSequence& random) {
  const double shore = LakeValley::shoreDistance(place);
  const double groups = fractalNoise({place / 42.0, 7.5}, 3), other = fractalNoise({place / 30.0, 9.5}, 3);
  const double high = smoothStep(15, 70, height);
  const std::array<double, kSpeciesCount> weights{
      0.5 + 2 * smoothStep(0.5, 0.65, groups) * (1 - high), 0.25 + 1.2 * smoothStep(30, 5, shore) + (1 - other) * 0.4,
      0.25 + 2.2 * high + 2.5 * smoothStep(0.48, 0.36, groups), 0.2 + 1.2 * high * smoothStep(0.45, 0.6, other),
      0.12 + 1.6 * smoothStep(0.52, 0.66, other) * (1 - 0.8 * high)};
  double total = 0;
  for (const double weight : weights) total += weight;
  double rest = random.next() * total;
  std::size_t species = 0;
  while (species + 1 < weights.size() && rest >= weights[species]) rest -= weights[species++];
  return static_cast<Species>(species);
}

Tree treeAt(const LakeValley& valley, Candidate candidate) {
  HashSequence& random = candidate.random;
  const double height = valley.heightAt(candidate.place);
  Tree tree;
  tree.species = speciesAt(candidate.place, height, random);
  const double size = 0.7 + 0.7 * 0.5 * (random.next() + random.next());
  const double width = std::clamp(size * random.between(0.88, 1.12), 0.7, 1.4);
  tree.place = {{candidate.place.x, height, candidate.place.y}, random.between(0, kTurn), {width, size, width}};
  const double autumn = fractalNoise({candidate.place / 25.0, 12.5}, 2) + random.between(-0.25, 0.25);
  tree.tint = autumn < 0.45 ? 0 : autumn < 0.62 ? 1 : 2;
  return tree;
}

// Returns a rock of about 1 m around the origin, flatter below.
TriangleMesh rock(std::uint32_t seed) {
  TriangleMesh mesh = lathe(sphereProfile(1, 14), 24);
  const auto displaced = [&](const dvec3& p) {
    const double radius = 0.55 + 0.6 * valueNoise(1.3 * p + 40.0 * seed, seed) + 0.3 * valueNoise(3.1 * p + 9.0, seed) +
                          0.12 * valueNoise(7.0 * p, seed);
    return dvec3(1.1, 0.75, 0.9) * p * radius;
  };
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    constexpr double kStep = 0.01;
    const dvec3 p(mesh.positions[i]);
    const dvec3 side = normalize(std::abs(p.y) < 0.9 ? cross(dvec3(0, 1, 0), p) : cross(dvec3(1, 0, 0), p));
    const dvec3 other = cross(p, side);
    const dvec3 here = displaced(p);
    const dvec3 normal = cross(displaced(normalize(p + kStep * side)) - here,
                               displaced(normalize(p + kStep * other)) - here);
    mesh.positions[i] = glm::vec3(here);
    mesh.normals[i] = glm::vec3(normalize(normal));
  }
  mesh.texCoords.clear();
  return mesh;
}

std::size_t addMatte(GltfDocument& document, const dvec3& colour, double roughness) {
  GltfDocument::Json material = gltfMaterial({.colour = colour, .roughness = roughness});
  material["doubleSided"] = true;
  return document.addMaterial(material);
}

void addTrees(GltfDocument& document, const std::vector<Tree>& trees) {
  for (std::size_t species = 0; species < kSpeciesCount; ++species) {
    const Plant& plant = speciesModels()[species];
    const SpeciesColours& colours = speciesColours()[species];
    const std::size_t bark = document.addShape(plant.bark), leaves = document.addShape(plant.leaves);
    const std::size_t barkMaterial = addMatte(document, colours.bark, 0.9);
    for (std::size_t tint = 0; tint < kTintCount; ++tint) {
      std::vector<MeshInstance> places;
      for (const Tree& tree : trees) {
        if (static_cast<std::size_t>(tree.species) == species && tree.tint == tint) places.push_back(tree.place);
      }
      if (places.empty()) continue;
      const MeshPart parts[] = {{bark, barkMaterial}, {leaves, addMatte(document, colours.leaves[tint], 0.7)}};
      document.addInstances(document.addMesh(parts), places);
    }
  }
}

void addInstances(GltfDocument& document, const TriangleMesh& mesh, std::size_t material,
                  const std::vector<MeshInstance>& places) {
  const MeshPart part{document.addShape(mesh), material};
  document.addInstances(document.addMesh({&part, 1}), places);
}

}  // namespace

std::vector<Tree> plantTrees(const LakeValley& valley, std::uint32_t count) {
  const dvec2 centre(4, -170);
  // The nearest trees of a square that holds twice as many as are needed where one tree has 60 square metres.
  const auto reach = static_cast<std::int32_t>((90 + std::sqrt(30.0 * count)) / kCell);
  const dvec2 middle = floor(centre / kCell);
  struct Ranked {
    double rank;
    Candidate candidate;
  };
  std::vector<Ranked> ranked;
  for (std::int32_t row = -reach; row <= reach; ++row) {
    for (std::int32_t column = -reach; column <= reach; ++column) {
      const std::int32_t x = column + static_cast<std::int32_t>(middle.x),
                         y = row + static_cast<std::int32_t>(middle.y);
      const Candidate candidate = candidateOf(x, y);
      if (!isKept(valley, candidate, x, y)) continue;
      const double edge = 0.75 + 0.5 * fractalNoise({candidate.place / 80.0, 17.5}, 3);
      const dvec2 offset = candidate.place - centre;
      const double behind = std::max(0.0, offset.y - 165);
      ranked.push_back({length(dvec2(offset.x, offset.y + 2 * behind)) * edge, candidate});
    }
  }
  std::ranges::stable_sort(ranked, {}, &Ranked::rank);
  ranked.resize(std::min<std::size_t>(ranked.size(), count), ranked.front());
  std::vector<Tree> trees;
  for (const Ranked& each : ranked) trees.push_back(treeAt(valley, each.candidate));
  return trees;
}

std::vector<MeshInstance> placeRocks(const LakeValley& valley) {
  constexpr double kRockCell = 4;
  std::vector<MeshInstance> places;
  for (std::int32_t row = -50; row <= 6; ++row) {
    for (std::int32_t column = -30; column <= 34; ++column) {
      HashSequence random(kRockSeed, column, row);
      const dvec2 place = kRockCell * dvec2{column + random.next(), row + random.next()};
      const double shore = LakeValley::shoreDistance(place);
      const double probability = 0.5 * smoothStep(-3, 0, shore) * smoothStep(7, 2, shore) +
                                 0.03 * smoothStep(0, 6, shore);
      if (random.next() > probability || length(place - kEyePlace) < 7) continue;
      const double size = 0.25 + 1.3 * std::pow(random.next(), 3);
      places.push_back({{place.x, valley.heightAt(place) - 0.1 * size, place.y},
                        random.between(0, kTurn),
                        size * dvec3{random.between(0.8, 1.4), random.between(0.6, 1.1), 1}});
    }
  }
  return places;
}

std::vector<MeshInstance> placeTufts(const LakeValley& valley) {
  constexpr double kTuftCell = 0.55;
  std::vector<MeshInstance> places;
  for (std::int32_t row = -100; row <= 0; ++row) {
    for (std::int32_t column = -80; column <= 80; ++column) {
      HashSequence random(kTuftSeed, column, row);
      const dvec2 place = kTuftCell * dvec2{column + random.next(), row + random.next()};
      const double shore = LakeValley::shoreDistance(place);
      if (shore < 0.4 || std::abs(place.x) > 5 - 0.75 * place.y) continue;
      const double density = smoothStep(0.3, 0.6, fractalNoise({place / 5.0, 21.5}, 3)) * smoothStep(60, 25, -place.y);
      if (random.next() > density) continue;
      const double size = random.between(0.6, 1.25);
      places.push_back({{place.x, valley.heightAt(place), place.y}, random.between(0, kTurn), dvec3(size)});
    }
  }
  return places;
}

std::uint64_t forestPrimitives(std::uint32_t size) {
  const LakeValley valley;
  std::uint64_t count = valley.groundMesh().triangleCount() + LakeValley::waterMesh().triangleCount();
  for (const Tree& tree : plantTrees(valley, size)) {
    const Plant& plant = speciesModels()[static_cast<std::size_t>(tree.species)];
    count += plant.bark.triangleCount() + plant.leaves.triangleCount();
  }
  count += placeRocks(valley).size() * rock(0).triangleCount();
  return count + placeTufts(valley).size() * grassTuft(kBlades, 0).triangleCount();
}

void writeForest(NffWriter& out, std::uint32_t size) {
  GltfDocument document;
  const LakeValley valley;
  const std::size_t ground = document.addMaterial(gltfMaterial({.colour = dvec3(1), .roughness = 0.95}));
  document.addNode(document.addShape(valley.groundMesh()), ground, dvec3(0));
  const std::size_t water = document.addMaterial(
      gltfMaterial({.colour = {0.012, 0.028, 0.03}, .roughness = 0.04, .ior = 1.333}));
  document.addNode(document.addShape(LakeValley::waterMesh()), water, dvec3(0));
  addTrees(document, plantTrees(valley, size));
  const std::vector<MeshInstance> rocks = placeRocks(valley);
  for (std::size_t shape = 0; shape < kRockShapes; ++shape) {
    std::vector<MeshInstance> places;
    for (std::size_t i = shape; i < rocks.size(); i += kRockShapes) places.push_back(rocks[i]);
    const double grey = 0.2 + 0.07 * static_cast<double>(shape);
    addInstances(document, rock(static_cast<std::uint32_t>(shape)),
                 addMatte(document, grey * dvec3(1, 0.96, 0.9), 0.85), places);
  }
  addInstances(document, grassTuft(kBlades, 1), addMatte(document, {0.19, 0.215, 0.045}, 0.7), placeTufts(valley));
  const dvec3 eye(kEyePlace.x, valley.heightAt(kEyePlace) + kEyeHeight, kEyePlace.y);
  document.addCamera(eye, {5, 11, -105}, 38, 16.0 / 9);
  out.text(document.text());
}

}  // namespace candela::generate
