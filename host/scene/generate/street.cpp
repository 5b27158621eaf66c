// street: streets at night, lit by windows, signs, street lamps and cars.
#include <algorithm>
#include <array>

#include "host/scene/generate/gltf_material.h"
#include "host/scene/generate/many_lights.h"
#include "host/scene/generate/street_builder.h"

namespace candela::generate {
namespace {

using glm::dvec3;

// Materials of which there is one, in the order of StreetPart, and the two lanterns.
constexpr std::array<MaterialFactors, StreetPart::house> kStreetMaterials{
    {{.colour = {0.05, 0.05, 0.055}, .roughness = 0.35},
     {.colour = {0.22, 0.21, 0.2}, .roughness = 0.7},
     {.colour = {0.7, 0.7, 0.7}, .roughness = 0.6},
     {.colour = {0.5, 0.47, 0.42}, .roughness = 0.8},
     {.colour = {0.12, 0.12, 0.12}, .roughness = 0.5},
     {.colour = {0.02, 0.02, 0.02}, .roughness = 0.08},
     {.colour = {0.1, 0.16, 0.1}, .roughness = 0.4},
     {.colour = {0.1, 0.1, 0.1}, .roughness = 0.9},
     {.colour = {0.05, 0.05, 0.05}, .roughness = 0.4},
     {.colour = {0.015, 0.015, 0.015}, .roughness = 0.15},
     {.colour = {0.02, 0.02, 0.02}, .emission = {250, 240, 225}},
     {.colour = {0.02, 0.02, 0.02}, .emission = {20, 0.8, 0.4}},
     {.colour = {0.02, 0.02, 0.02}, .emission = {8, 4, 0.4}},
     {.colour = {0.02, 0.02, 0.02}, .emission = {1500, 1400, 1200}},
     {.colour = {0.02, 0.02, 0.02}, .emission = {1500, 900, 300}}}};

constexpr std::array<dvec3, kHouseColours> kHousePaints{
    {{0.36, 0.15, 0.09}, {0.5, 0.42, 0.3}, {0.45, 0.44, 0.42}, {0.32, 0.26, 0.2}, {0.5, 0.34, 0.24}}};
constexpr std::array<dvec3, kCarColours> kCarPaints{
    {{0.5, 0.5, 0.5}, {0.03, 0.03, 0.03}, {0.45, 0.03, 0.02}, {0.05, 0.12, 0.3}}};

// Windows have one of these colours and one of three radiances.
constexpr std::array<dvec3, kShopWindowKinds> kWindowLight{
    {{1, 0.72, 0.4}, {1, 0.85, 0.62}, {1, 0.55, 0.22}, {0.5, 0.68, 1}}};
constexpr std::array<double, kWindowKinds / kShopWindowKinds> kWindowRadiance{0.4, 1.2, 4};
constexpr double kShopRadiance = 3, kSignRadiance = 6;

MaterialFactors streetMaterial(std::size_t part) {
  if (part < StreetPart::house) return kStreetMaterials[part];
  if (part < StreetPart::car) return {.colour = kHousePaints[part - StreetPart::house], .roughness = 0.85};
  if (part < StreetPart::shopWindow) return {.colour = kCarPaints[part - StreetPart::car], .roughness = 0.25};
  MaterialFactors material{.colour = dvec3(0.02), .roughness = 0.1};
  if (part < StreetPart::window) {
    material.emission = kShopRadiance * kWindowLight[part - StreetPart::shopWindow];
  } else if (part < StreetPart::sign) {
    const std::size_t kind = part - StreetPart::window;
    material.emission = kWindowRadiance[kind / kShopWindowKinds] * kWindowLight[kind % kShopWindowKinds];
  } else {
    material.emission = dvec3(kSignRadiance);
  }
  return material;
}

std::uint32_t plotCount(std::uint32_t emitters) {
  const std::uint32_t pairs = emitters / 2, pairsOfPlot = StreetBuilder::kPlotEmitters / 2;
  return pairs / pairsOfPlot + (pairs % pairsOfPlot > 0 ? 1 : 0);
}

// The numbers of triangles of a road, of a plot, and of what a street with an odd number of emitters has in addition.
struct StreetCounts {
  std::uint64_t road, plot, odd;
};

StreetCounts streetCounts() {
  StreetBuilder road(0), plot(0);
  road.addRoad(0, 1);
  plot.addPlot(0);
  return {road.triangleCount(), plot.triangleCount(), StreetBuilder(1).triangleCount()};
}

}  // namespace

std::uint64_t streetPrimitives(std::uint32_t size) {
  static const StreetCounts counts = streetCounts();
  const std::uint64_t plots = plotCount(size);
  const std::uint64_t streets = (plots + StreetBuilder::kPlotsPerStreet - 1) / StreetBuilder::kPlotsPerStreet;
  return counts.road * streets + counts.plot * plots + counts.odd * (size % 2);
}

void writeStreet(NffWriter& out, std::uint32_t size) {
  StreetBuilder street(size);
  const std::uint32_t plots = plotCount(size);
  for (std::uint32_t plot = 0; plot < plots; ++plot) {
    if (plot % StreetBuilder::kPlotsPerStreet == 0) {
      street.addRoad(plot, std::min(StreetBuilder::kPlotsPerStreet, plots - plot));
    }
    street.addPlot(plot);
  }
  GltfDocument document;
  const std::vector<SignPicture> pictures = signPictures();
  for (std::size_t part = 0; part < StreetPart::count; ++part) {
    const TriangleMesh& mesh = street.meshes()[part];
    if (mesh.indices.empty()) continue;
    GltfDocument::Json material = gltfMaterial(streetMaterial(part));
    if (part >= StreetPart::sign) {
      const SignPicture& picture = pictures[part - StreetPart::sign];
      material["emissiveTexture"] = {
          {"index", document.addTexture(SignPicture::kWidth, SignPicture::kHeight, picture.rgb)}};
    }
    document.addNode(document.addShape(mesh), document.addMaterial(material), dvec3(0));
  }
  document.addCamera({1.4, 1.9, -0.5}, {0.3, 3.8, -35}, 50, 16.0 / 9);
  out.text(document.text());
}

}  // namespace candela::generate
