// The list of the sums from which layers are computed.
#ifndef CANDELA_LISTS_LAYER_SUMS_H
#define CANDELA_LISTS_LAYER_SUMS_H

// X(image::LayerSum, whether a kernel has it in GLSL, its first record of a pixel in GLSL, bit in the mask of sums,
// number of channels). The channels of a pixel are stored in this order, after one header. docs/layers.md.
#define CANDELA_LAYER_SUMS(X)                                        \
  X(normal, kSumsNormal, kNormalSumRow, 0u, 3u)                      \
  X(albedo, kSumsAlbedo, kAlbedoSumRow, 1u, 3u)                      \
  X(depth, kSumsDepth, kDepthSumRow, 2u, 1u)                         \
  X(position, kSumsPosition, kPositionSumRow, 3u, 3u)                \
  X(texCoord, kSumsTexCoord, kTexCoordSumRow, 4u, 2u)                \
  X(unscattered, kSumsUnscattered, kUnscatteredSumRow, 5u, 3u)       \
  X(scatteredOnce, kSumsScatteredOnce, kScatteredOnceSumRow, 6u, 3u) \
  X(rootRadiance, kSumsRootRadiance, kRootRadianceSumRow, 7u, 3u)    \
  X(albedoSquared, kSumsAlbedoSquared, kAlbedoSquaredSumRow, 8u, 1u)

#endif
