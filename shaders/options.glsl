// The specialisation constants by name, and constants that are derived from them.
#ifndef CANDELA_OPTIONS_GLSL
#define CANDELA_OPTIONS_GLSL
#include "../lists/features.h"
#include "../lists/layer_sums.h"
#include "../lists/primitive_kinds.h"
#include "shared/scene_rows.h"
#include "shared/specialization.h"

#define DECLARE_FEATURE(member, name, id) layout(constant_id = id) const bool name = true;
CANDELA_FEATURES(DECLARE_FEATURE)
#undef DECLARE_FEATURE
layout(constant_id = kSpecOneSided) const bool kOneSided = false;
layout(constant_id = kSpecLimitsIndirect) const bool kLimitsIndirect = false;
layout(constant_id = kSpecLayerSums) const uint kLayerSums = 0u;
layout(constant_id = kSpecCoincident) const uint kCoincident = 0xffffffffu;
layout(constant_id = kSpecOrderReach) const uint kOrderReach = 0x3f800000u;
layout(constant_id = kSpecFilmScale) const uint kFilmScale = 0u;
layout(constant_id = kSpecListsHits) const bool kListsHits = false;
layout(constant_id = kSpecThroughSpecular) const bool kThroughSpecular = false;
layout(constant_id = kSpecTextureSlots) const uint kTextureSlots = 0xffffffffu;
layout(constant_id = kSpecBackdrop) const uint kBackdrop = kBackdropEnvironment;
layout(constant_id = kSpecLens) const uint kLens = kLensDisc;
layout(constant_id = kSpecFilter) const uint kFilter = kFilterBox;
layout(constant_id = kSpecFilterDeviation) const uint kFilterDeviation = 0x3f000000u;
layout(constant_id = kSpecSampler) const uint kSampler = kSamplerSobol;
layout(constant_id = kSpecStructure) const uint kStructure = kStructureBvh;
layout(constant_id = kSpecTexels) const bool kTexelLoads = false;
layout(constant_id = kSpecRecord) const bool kRecordPaths = false;
layout(constant_id = kSpecStackSize) const uint kStackSize = 64u;
layout(constant_id = kSpecUniformSlots) const uint kUniformSlots = 0u;
layout(constant_id = kSpecFirstMarkedSlot) const uint kFirstMarkedSlot = 0u;
layout(constant_id = kSpecRowsAhead) const bool kRowsAhead = false;
layout(constant_id = kSpecMasksLanes) const bool kMasksLanes = true;
layout(constant_id = kSpecLimitsLoops) const bool kLimitsLoops = true;
layout(constant_id = kSpecAreaLights) const bool kHasAreaLights = true;
layout(constant_id = kSpecView) const uint kView = kViewNone;
layout(constant_id = kSpecUniformKinds + 0u) const uint kKinds0 = 0u;
layout(constant_id = kSpecUniformKinds + 1u) const uint kKinds1 = 0u;
layout(constant_id = kSpecUniformKinds + 2u) const uint kKinds2 = 0u;
layout(constant_id = kSpecUniformKinds + 3u) const uint kKinds3 = 0u;
layout(constant_id = kSpecUniformKinds + 4u) const uint kKinds4 = 0u;
layout(constant_id = kSpecUniformKinds + 5u) const uint kKinds5 = 0u;
layout(constant_id = kSpecUniformKinds + 6u) const uint kKinds6 = 0u;
layout(constant_id = kSpecUniformKinds + 7u) const uint kKinds7 = 0u;
layout(constant_id = kSpecUniformKinds + 8u) const uint kKinds8 = 0u;
layout(constant_id = kSpecUniformKinds + 9u) const uint kKinds9 = 0u;
const uvec4 kKindsOfSlots0 = uvec4(kKinds0, kKinds1, kKinds2, kKinds3);
const uvec4 kKindsOfSlots16 = uvec4(kKinds4, kKinds5, kKinds6, kKinds7);
const uvec4 kKindsOfSlots32 = uvec4(kKinds8, kKinds9, 0u, 0u);

// The kind of all primitives if the scene has only one kind. kManyKinds: the kind of each primitive must be read.
const uint kManyKinds = 7u;
#define COUNT_KIND(kind, feature, name, value, flag) +uint(flag)
const uint kKindCount = CANDELA_PRIMITIVE_KINDS(COUNT_KIND);
#undef COUNT_KIND
#define CHOOSE_KIND(kind, feature, name, value, flag) flag ? name :
const uint kOnlyKind = kKindCount != 1u ? kManyKinds : CANDELA_PRIMITIVE_KINDS(CHOOSE_KIND) kManyKinds;
#undef CHOOSE_KIND

// The sums of layers that exist, the first record of each in a pixel's records, and the number of these records.
#define DECLARE_SUM(sum, has, row, bit, count) const bool has = (kLayerSums & (1u << bit)) != 0u;
CANDELA_LAYER_SUMS(DECLARE_SUM)
#undef DECLARE_SUM
const uint kNormalSumRow = 1u;
const uint kAlbedoSumRow = kNormalSumRow + (kSumsNormal ? 3u : 0u);
const uint kDepthSumRow = kAlbedoSumRow + (kSumsAlbedo ? 3u : 0u);
const uint kPositionSumRow = kDepthSumRow + (kSumsDepth ? 1u : 0u);
const uint kTexCoordSumRow = kPositionSumRow + (kSumsPosition ? 3u : 0u);
const uint kUnscatteredSumRow = kTexCoordSumRow + (kSumsTexCoord ? 2u : 0u);
const uint kScatteredOnceSumRow = kUnscatteredSumRow + (kSumsUnscattered ? 3u : 0u);
const uint kRootRadianceSumRow = kScatteredOnceSumRow + (kSumsScatteredOnce ? 3u : 0u);
const uint kAlbedoSquaredSumRow = kRootRadianceSumRow + (kSumsRootRadiance ? 3u : 0u);
const uint kLayerRows = kAlbedoSquaredSumRow + (kSumsAlbedoSquared ? 1u : 0u);
const bool kHasTexCoords = kHasTextures || kSumsTexCoord;
const bool kHasAttributes = kHasSmooth || kHasTexCoords || kHasColours || kHasTangents;

const bool kCountsHits = kBackdrop == kBackdropNone;
const bool kHasCoincident = kCoincident != 0u;
const bool kSpheresCoincide = (kCoincident & kCoincidentSphere) != 0u;
const bool kTrianglesCoincide = (kCoincident & kCoincidentTriangle) != 0u;
const bool kBoxesCoincide = (kCoincident & kCoincidentBox) != 0u;
const bool kConesCoincide = (kCoincident & kCoincidentCone) != 0u;
const bool kPlanesCoincide = (kCoincident & kCoincidentPlane) != 0u;
const bool kLightCrossesCoincident = (kCoincident & kCoincidentTransmits) != 0u;
const bool kEmittersCoincide = (kCoincident & kCoincidentEmitters) != 0u;
const bool kHasOrdered = kHasCoincident && kOrderReach != 0u;
const bool kLoopsOverPlanes = kHasPlanes && kUniformSlots == 0u;
const bool kHasFlat = kHasTriangles || kHasBoxes || kHasPlanes;
const bool kHasSampledEmitters = kHasSphereLights || kHasTriangleLights;
const bool kHasLights = kHasSampledEmitters || kHasPointLights || kHasPunctualLights || kHasEnvironmentLight;

#endif
