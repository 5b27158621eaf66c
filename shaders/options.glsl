// The specialisation constants, by name.
#ifndef CANDELA_OPTIONS_GLSL
#define CANDELA_OPTIONS_GLSL
#include "shared/scene_rows.h"
#include "shared/specialization.h"

layout(constant_id = kSpecSpheres) const bool kHasSpheres = true;
layout(constant_id = kSpecTriangles) const bool kHasTriangles = true;
layout(constant_id = kSpecBoxes) const bool kHasBoxes = true;
layout(constant_id = kSpecCones) const bool kHasCones = true;
layout(constant_id = kSpecPlanes) const bool kHasPlanes = true;
layout(constant_id = kSpecSmooth) const bool kHasSmooth = true;
layout(constant_id = kSpecDiffuse) const bool kHasDiffuse = true;
layout(constant_id = kSpecGlossy) const bool kHasGlossy = true;
layout(constant_id = kSpecMirror) const bool kHasMirror = true;
layout(constant_id = kSpecDielectric) const bool kHasDielectric = true;
layout(constant_id = kSpecEmission) const bool kHasEmission = true;
layout(constant_id = kSpecSphereLights) const bool kHasSphereLights = true;
layout(constant_id = kSpecTriangleLights) const bool kHasTriangleLights = true;
layout(constant_id = kSpecPointLights) const bool kHasPointLights = true;
layout(constant_id = kSpecInsideOnly) const bool kHasInsideOnly = true;
layout(constant_id = kSpecSky) const bool kHasSky = true;
layout(constant_id = kSpecOneSided) const bool kOneSided = false;
layout(constant_id = kSpecLens) const uint kLens = kLensDisc;
layout(constant_id = kSpecFilter) const uint kFilter = kFilterBox;
layout(constant_id = kSpecSampler) const uint kSampler = kSamplerSobol;
layout(constant_id = kSpecStructure) const uint kStructure = kStructureBvh;
layout(constant_id = kSpecTexels) const bool kTexelLoads = false;
layout(constant_id = kSpecRecord) const bool kRecordPaths = false;
layout(constant_id = kSpecStackSize) const uint kStackSize = 64u;
layout(constant_id = kSpecUniformSlots) const uint kUniformSlots = 0u;
layout(constant_id = kSpecUniformPlanes) const bool kUniformPlanes = false;
layout(constant_id = kSpecUniformKinds0) const uint kUniformKinds0 = 0u;
layout(constant_id = kSpecUniformKinds1) const uint kUniformKinds1 = 0u;
layout(constant_id = kSpecUniformKinds2) const uint kUniformKinds2 = 0u;
layout(constant_id = kSpecUniformKinds3) const uint kUniformKinds3 = 0u;
layout(constant_id = kSpecMixtures) const bool kHasMixtures = true;
layout(constant_id = kSpecAreaLights) const bool kHasAreaLights = true;
layout(constant_id = kSpecView) const uint kView = kViewNone;

// The kind of every primitive where the scene has only one; kManyKinds: each must be looked at.
const uint kManyKinds = 7u;
const uint kKindCount = uint(kHasSpheres) + uint(kHasTriangles) + uint(kHasBoxes) + uint(kHasCones) + uint(kHasPlanes);
const uint kOnlyKind = kKindCount != 1u ? kManyKinds
                       : kHasSpheres ? kKindSphere
                       : kHasTriangles ? kKindTriangle : kHasBoxes ? kKindBox : kHasCones ? kKindCone : kKindPlane;
const bool kLoopsOverPlanes = kHasPlanes && !kUniformPlanes;
const bool kHasFlat = kHasTriangles || kHasBoxes || kHasPlanes;
const bool kHasSampledEmitters = kHasSphereLights || kHasTriangleLights;
const bool kHasLights = kHasSampledEmitters || kHasPointLights;

#endif
