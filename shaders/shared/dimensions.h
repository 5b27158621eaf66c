// Names of the random numbers that a path uses, for GLSL and for C++ (including the reference). A number is requested
// by name, never by the count of previous calls, so both tracers use the same number for the same decision.
#ifndef CANDELA_SHARED_DIMENSIONS_H
#define CANDELA_SHARED_DIMENSIONS_H

#ifdef __cplusplus
#include <cstdint>
#define CANDELA_DIMENSION inline constexpr std::uint32_t
namespace candela {
#else
#define CANDELA_DIMENSION const uint
#endif

// The camera's block.
CANDELA_DIMENSION kDimensionFilterX = 0u;
CANDELA_DIMENSION kDimensionFilterY = 1u;
CANDELA_DIMENSION kDimensionLensU = 2u;
CANDELA_DIMENSION kDimensionLensV = 3u;
CANDELA_DIMENSION kCameraDimensionCount = 8u;

// The block of path vertex n (n = 1 is the camera ray's hit) starts at kCameraDimensionCount + (n - 1) *
// kVertexDimensionCount; these are offsets into it.
CANDELA_DIMENSION kDimensionLightChoice = 0u;
CANDELA_DIMENSION kDimensionLightU = 1u;
CANDELA_DIMENSION kDimensionLightV = 2u;
CANDELA_DIMENSION kDimensionLobe = 3u;
CANDELA_DIMENSION kDimensionBsdfU = 4u;
CANDELA_DIMENSION kDimensionBsdfV = 5u;
CANDELA_DIMENSION kDimensionRoulette = 6u;
CANDELA_DIMENSION kDimensionMaterial = 7u;  // of materials that are choices
CANDELA_DIMENSION kVertexDimensionCount = 8u;
// Offsets of numbers that only some surfaces use (normal maps, dispersion, textures). They lie beyond the blocks of the
// longest path, so that scenes without such surfaces use no other numbers.
CANDELA_DIMENSION kDimensionFacet = 0x80000000u;  // of normal-mapped surfaces
CANDELA_DIMENSION kDimensionLayer = 0x80000001u;
CANDELA_DIMENSION kDimensionCoatFacet = 0x80000002u;
CANDELA_DIMENSION kDimensionChannel = 0x80000003u;  // of surfaces with dispersion
CANDELA_DIMENSION kDimensionTextureU = 0x80000004u;
CANDELA_DIMENSION kDimensionTextureV = 0x80000005u;
CANDELA_DIMENSION kDimensionLightTextureU = 0x80000006u;  // at the sampled point of a light
CANDELA_DIMENSION kDimensionLightTextureV = 0x80000007u;

// The environment's numbers of path vertex n start at kEnvironmentDimensions + (n - 1) * kEnvironmentDimensionCount:
// above the blocks of the longest path, so that the environment takes no number of a vertex's block, and below twice
// their start.
CANDELA_DIMENSION kEnvironmentDimensions = 1u << 24;
CANDELA_DIMENSION kDimensionTapX = 0u;
CANDELA_DIMENSION kDimensionTapY = 1u;
CANDELA_DIMENSION kDimensionTexelX = 2u;
CANDELA_DIMENSION kDimensionTexelY = 3u;
CANDELA_DIMENSION kEnvironmentDimensionCount = 4u;

// The numbers of the light tree of path vertex n start at kLightTreeDimensions + (n - 1) * kLightTreeDimensionCount,
// one for each depth of the tree.
CANDELA_DIMENSION kLightTreeDimensions = 1u << 30;
CANDELA_DIMENSION kLightTreeDimensionCount = 32u;
// Those of the tree of a mesh start at kMeshTreeDimensions + (n - 1) * kLightTreeDimensionCount.
CANDELA_DIMENSION kMeshTreeDimensions = 3u << 29;

#undef CANDELA_DIMENSION
#ifdef __cplusplus
}  // namespace candela
#endif
#endif
