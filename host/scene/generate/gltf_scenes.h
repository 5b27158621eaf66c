// The generators of glTF scenes: for each kind, its number of triangles and its content. Sizes are those of the table
// of kinds: the number of steps from pole to pole of each ball, where nothing else is said.
#pragma once
#include <cstdint>

#include "host/scene/generate/nff_writer.h"

namespace candela::generate {

/// Balls of six roughnesses (columns) and five mixtures of metal, plastic and glass (rows).
std::uint64_t materialTablePrimitives(std::uint32_t size);
void writeMaterialTable(NffWriter& out, std::uint32_t size);

/// Balls that absorb nothing, of every kind of lobe; in an environment of one radiance they should not be visible.
std::uint64_t materialFurnacePrimitives(std::uint32_t size);
void writeMaterialFurnace(NffWriter& out, std::uint32_t size);

/// Balls of six roughnesses (columns) that are rougher in one direction: of metal, plastic and glass (rows).
std::uint64_t brushedTablePrimitives(std::uint32_t size);
void writeBrushedTable(NffWriter& out, std::uint32_t size);

/// Three round brilliants with as many bezels as the size says, at least 6, between lamps: without dispersion, and with
/// that of diamond and of rutile.
std::uint64_t brilliantsPrimitives(std::uint32_t size);
void writeBrilliants(NffWriter& out, std::uint32_t size);

/// A glazed vase, a tumbler, a bowl and balls of glass, gold, copper and plastic on tiles.
std::uint64_t stillLifePrimitives(std::uint32_t size);
void writeStillLife(NffWriter& out, std::uint32_t size);

/// Trees of five species, as many as the size says, around a lake between hills.
std::uint64_t forestPrimitives(std::uint32_t size);
void writeForest(NffWriter& out, std::uint32_t size);

/// Buildings of five models, as many as the size says, along the streets of a city with a tall centre.
std::uint64_t cityPrimitives(std::uint32_t size);
void writeCity(NffWriter& out, std::uint32_t size);

}  // namespace candela::generate
