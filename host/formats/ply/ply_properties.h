// The properties of PLY files that are rendered, by the names that programs give them.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/formats/ply/ply_header.h"

namespace candela::ply {

/// The numbers of a vertex, in the order of VertexPlan::slots.
enum Slot : std::uint8_t { kX, kY, kZ, kNx, kNy, kNz, kRed, kGreen, kBlue, kAlpha, kS, kT, kSlotCount };

/// The use of the properties of vertices.
struct VertexPlan {
  /// By property: the slot of its number, or kSlotCount.
  std::vector<std::uint8_t> slots;
  bool hasNormals = false;
  bool hasColours = false;
  bool hasAlpha = false;
  bool hasTexCoords = false;
};

/// Finds positions (x y z), normals (nx ny nz), colours (red green blue alpha, r g b a, or with the prefix "diffuse_")
/// and texture coordinates (s t, u v, texture_u texture_v, texture_s texture_t). A set that is not complete is not
/// used; alpha may be missing. Nothing if there are no positions.
std::optional<VertexPlan> planOf(const Element& vertex);

/// Returns the list that has the vertices of faces or strips, by its index: vertex_indices or vertex_index.
std::optional<std::size_t> findIndexList(const Element& face);

/// Returns whether pictures do not show the property, whatever it says: confidence, intensity and other measurements.
bool isMeasurement(const Property& property);

}  // namespace candela::ply
