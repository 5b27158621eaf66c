// Names of properties.
#include "host/formats/ply/ply_properties.h"

#include <algorithm>
#include <span>
#include <string_view>

namespace candela::ply {
namespace {

/// The names of a set, for consecutive slots.
struct Names {
  Slot first;
  std::array<std::string_view, 3> names;  ///< of texture coordinates two
};

// Among several sets of the same slots, the first is used.
constexpr std::array kSets{
    Names{kX, {"x", "y", "z"}}, Names{kNx, {"nx", "ny", "nz"}},        Names{kS, {"s", "t"}},
    Names{kS, {"u", "v"}},      Names{kS, {"texture_u", "texture_v"}}, Names{kS, {"texture_s", "texture_t"}}};

constexpr std::array kColourSets{Names{kRed, {"red", "green", "blue"}},
                                 Names{kRed, {"diffuse_red", "diffuse_green", "diffuse_blue"}},
                                 Names{kRed, {"r", "g", "b"}}};
/// Endings of the names of channels, after "_".
constexpr std::array<std::string_view, 4> kEndings{"rgba", "0123", "1234", "xyzw"};

constexpr std::array<std::string_view, 3> kAlphaNames{"alpha", "diffuse_alpha", "a"};

std::optional<std::size_t> findNumber(const Element& element, std::string_view name) {
  const auto fits = [&](const Property& property) { return property.name == name && !property.countType; };
  const auto found = std::ranges::find_if(element.properties, fits);
  if (found == element.properties.end()) return std::nullopt;
  return static_cast<std::size_t>(found - element.properties.begin());
}

/// Returns whether all of the set exist, and then enters their slots.
bool enter(const Names& set, const Element& vertex, VertexPlan& plan) {
  const auto isEntered = [&](std::uint8_t slot) { return slot == set.first; };
  if (std::ranges::any_of(plan.slots, isEntered)) return true;
  std::vector<std::size_t> found;
  for (const std::string_view name : set.names) {
    if (name.empty()) continue;
    const std::optional<std::size_t> property = findNumber(vertex, name);
    if (!property) return false;
    found.push_back(*property);
  }
  for (std::size_t i = 0; i < found.size(); ++i) plan.slots[found[i]] = static_cast<std::uint8_t>(set.first + i);
  return true;
}

/// Enters the slots of an attribute of three channels, or of one.
void enterAttribute(std::string_view name, const Element& element, VertexPlan& plan) {
  for (const std::string_view endings : kEndings) {
    std::vector<std::size_t> found;
    for (const char ending : endings) {
      const std::optional<std::size_t> property = findNumber(element, std::string(name) + '_' + ending);
      if (!property) break;
      found.push_back(*property);
    }
    if (found.empty()) continue;
    plan.isGrey = found.size() == 1;
    plan.hasColours = plan.isGrey || found.size() == 3;
    for (std::size_t i = 0; plan.hasColours && i < found.size(); ++i)
      plan.slots[found[i]] = static_cast<std::uint8_t>(kRed + i);
    return;
  }
}

void enterColours(std::string_view name, const Element& element, VertexPlan& plan) {
  if (name.empty()) return;
  const auto isEntered = [&](const Names& set) { return enter(set, element, plan); };
  plan.hasColours = name == "color" && std::ranges::any_of(kColourSets, isEntered);
  if (!plan.hasColours) enterAttribute(name, element, plan);
  for (const std::string_view alphaName : kAlphaNames) {
    const std::optional<std::size_t> property = findNumber(element, alphaName);
    if (!property || !plan.hasColours || plan.hasAlpha) continue;
    plan.slots[*property] = kAlpha;
    plan.hasAlpha = true;
  }
}

VertexPlan emptyPlan(const Element& element) {
  return {.slots = std::vector<std::uint8_t>(element.properties.size(), kSlotCount)};
}

}  // namespace

std::optional<VertexPlan> planOf(const Element& vertex, std::string_view name) {
  VertexPlan plan = emptyPlan(vertex);
  std::array<bool, kSlotCount> has{};
  for (const Names& set : kSets) has[set.first] = enter(set, vertex, plan);
  if (!has[kX]) return std::nullopt;
  plan.hasNormals = has[kNx];
  plan.hasTexCoords = std::ranges::count(plan.slots, kS) > 0;
  enterColours(name, vertex, plan);
  return plan;
}

VertexPlan facePlanOf(const Element& face, std::string_view name) {
  VertexPlan plan = emptyPlan(face);
  enterColours(name, face, plan);
  return plan;
}

std::optional<std::size_t> findIndexList(const Element& face) {
  const auto fits = [](const Property& property) {
    return property.countType && (property.name == "vertex_indices" || property.name == "vertex_index");
  };
  const auto found = std::ranges::find_if(face.properties, fits);
  if (found == face.properties.end()) return std::nullopt;
  return static_cast<std::size_t>(found - face.properties.begin());
}

bool isMeasurement(const Property& property) {
  constexpr std::array<std::string_view, 8> kNames{"confidence", "intensity", "quality", "value",
                                                   "curvature",  "radius",    "flags",   "label"};
  return std::ranges::count(kNames, property.name) > 0 || property.name.starts_with("scalar_");
}

}  // namespace candela::ply
