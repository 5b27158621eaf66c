// The generators of scenes with many lights, for judging how a renderer chooses among them: for each kind, its number
// of primitives and its content. The size is the number of lamps, or of emissive triangles where that is said.
#pragma once
#include <cstdint>

#include "host/scene/generate/nff_writer.h"

namespace candela::generate {

/// A corridor between rooms, most of whose lamps are behind walls. Every fifth lamp is a sphere, the others are
/// rectangles of two triangles. The power of the lamps differs by a factor of up to 4096.
std::uint64_t corridorPrimitives(std::uint32_t size);
void writeCorridor(NffWriter& out, std::uint32_t size);

/// Streets at night, glTF: `size` emissive triangles of windows, signs with textures, street lamps and cars.
std::uint64_t streetPrimitives(std::uint32_t size);
void writeStreet(NffWriter& out, std::uint32_t size);

/// An open-plan office below equal panels of two triangles each.
std::uint64_t officePrimitives(std::uint32_t size);
void writeOffice(NffWriter& out, std::uint32_t size);

/// A small stage in front of equal lamps of two triangles each, far away: each lights every point of the stage by the
/// same amount, to 1 %.
std::uint64_t floodlightsPrimitives(std::uint32_t size);
void writeFloodlights(NffWriter& out, std::uint32_t size);

}  // namespace candela::generate
