// The properties of PLY files that are rendered, by the names that programs give them.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/formats/ply/ply_header.h"

namespace candela::ply {

/// The numbers of a vertex, in the order of VertexPlan::slots.
enum Slot : std::uint8_t { kX, kY, kZ, kNx, kNy, kNz, kRed, kGreen, kBlue, kAlpha, kS, kT, kSlotCount };

/// The use of the properties of vertices, or of the colours of faces.
struct VertexPlan {
  /// By property: the slot of its number, or kSlotCount.
  std::vector<std::uint8_t> slots;
  bool hasNormals = false;
  bool hasColours = false;
  bool isGrey = false;  ///< of colours: the number of kRed is that of green and blue, too
  bool hasAlpha = false;
  bool hasTexCoords = false;
};

/// Finds positions (x y z), normals (nx ny nz), texture coordinates (s t, u v, texture_u texture_v, texture_s
/// texture_t) and the colours `name`. A set that is not complete is not used. Nothing if there are no positions.
///
/// Colours are `name`_0 `name`_1 `name`_2, with the endings 1 2 3, r g b or x y z, or the first of these alone; those
/// of "color" also red green blue alpha, r g b a, or with the prefix "diffuse_", where alpha may be missing. An empty
/// name finds none.
std::optional<VertexPlan> planOf(const Element& vertex, std::string_view name);

/// Finds the colours `name` of faces, and nothing else.
VertexPlan facePlanOf(const Element& face, std::string_view name);

/// Returns the list that has the vertices of faces or strips, by its index: vertex_indices or vertex_index.
std::optional<std::size_t> findIndexList(const Element& face);

/// Returns whether pictures do not show the property, whatever it says: confidence, intensity and other measurements.
bool isMeasurement(const Property& property);

}  // namespace candela::ply
