// The generators: for each kind of scene, its number of primitives and its content. The sizes are those of the table of
// kinds. Sources: E. Haines, "A Proposal for Standard Graphics Environments", IEEE CG&A 7(11), 1987, and the Standard
// Procedural Databases 3.14, whose files all kinds but terrain, sphere and cornell reproduce.
#pragma once
#include <cstdint>

#include "host/scene/generate/nff_writer.h"

namespace candela::generate {

// Counts are of primitives as traced: a polygon of n vertices is n - 2 triangles, an area light is 2.

std::uint64_t ballsPrimitives(std::uint32_t size);
void writeBalls(NffWriter& out, std::uint32_t size);

std::uint64_t mountPrimitives(std::uint32_t size);
void writeMount(NffWriter& out, std::uint32_t size);

std::uint64_t tetraPrimitives(std::uint32_t size);
void writeTetra(NffWriter& out, std::uint32_t size);

std::uint64_t ringsPrimitives(std::uint32_t size);
void writeRings(NffWriter& out, std::uint32_t size);

std::uint64_t gearsPrimitives(std::uint32_t size);
void writeGears(NffWriter& out, std::uint32_t size);

std::uint64_t treePrimitives(std::uint32_t size);
void writeTree(NffWriter& out, std::uint32_t size);

std::uint64_t jacksPrimitives(std::uint32_t size);
void writeJacks(NffWriter& out, std::uint32_t size);

std::uint64_t latticePrimitives(std::uint32_t size);
void writeLattice(NffWriter& out, std::uint32_t size);

std::uint64_t shellsPrimitives(std::uint32_t size);
void writeShells(NffWriter& out, std::uint32_t size);

std::uint64_t sombreroPrimitives(std::uint32_t size);
void writeSombrero(NffWriter& out, std::uint32_t size);

std::uint64_t teapotPrimitives(std::uint32_t size);
void writeTeapot(NffWriter& out, std::uint32_t size);

std::uint64_t terrainPrimitives(std::uint32_t size);
void writeTerrain(NffWriter& out, std::uint32_t size);

std::uint64_t spherePrimitives(std::uint32_t size);
void writeSphere(NffWriter& out, std::uint32_t size);

std::uint64_t cornellPrimitives(std::uint32_t size);
void writeCornell(NffWriter& out, std::uint32_t size);

}  // namespace candela::generate
