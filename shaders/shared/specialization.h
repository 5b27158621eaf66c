// Ids of the specialisation constants, except for those of the feature flags, which are in lists/features.h.
#ifndef CANDELA_SHARED_SPECIALIZATION_H
#define CANDELA_SHARED_SPECIALIZATION_H
#include "language.h"
#include "scene_rows.h"
CANDELA_BEGIN

CANDELA_CONST uint kSpecWorkgroupX = 0u;
CANDELA_CONST uint kSpecWorkgroupY = 1u;

// The image.
CANDELA_CONST uint kSpecOneSided = 17u;
CANDELA_CONST uint kSpecLens = 18u;             // kLens...
CANDELA_CONST uint kSpecFilter = 19u;           // kFilter...
CANDELA_CONST uint kSpecFilterDeviation = 108u; // of kFilterGaussian in pixels, as the bits of a float
CANDELA_CONST uint kSpecSampler = 20u;          // kSampler...
CANDELA_CONST uint kSpecBackdrop = 91u;         // kBackdrop...
CANDELA_CONST uint kSpecView = 50u;             // kView...
CANDELA_CONST uint kSpecAreaLights = 40u;       // for the Whitted tracer: point lights have a size
CANDELA_CONST uint kSpecLimitsIndirect = 90u;   // contributions of indirect light have a maximum
CANDELA_CONST uint kSpecFilmScale = 89u;        // k: the film adds samples times 2^-k
CANDELA_CONST uint kSpecLayerSums = 93u;        // the sums of CANDELA_LAYER_SUMS that the film has, a bit each
CANDELA_CONST uint kSpecListsHits = 94u;        // the film has a list of the primitives that camera rays hit
CANDELA_CONST uint kSpecThroughSpecular = 98u;  // layers show what is seen in perfect mirrors and through glass
CANDELA_CONST uint kSpecRecord = 23u;           // the decisions of each path are recorded

// The scene.
CANDELA_CONST uint kSpecTextureSlots = 92u;  // a bit for each texture slot that some material of the scene uses
CANDELA_CONST uint kSpecCoincident = 88u;  // kCoincident..., a bit for each kind of surface that coincides with another
// The largest coordinate of the surfaces that are ordered in a plane, as the bits of a float; 0: there are none.
CANDELA_CONST uint kSpecOrderReach = 99u;

// The acceleration structure, and how it is read.
CANDELA_CONST uint kSpecStructure = 21u;  // kStructure...
CANDELA_CONST uint kSpecTexels = 22u;     // the scene is read through the texel buffer
CANDELA_CONST uint kSpecStackSize = 24u;
CANDELA_CONST uint kSpecUniformSlots = 27u;     // primitives whose records are in the uniform buffer; 0: none
CANDELA_CONST uint kSpecFirstMarkedSlot = 97u;  // of these, the first that may coincide with another
CANDELA_CONST uint kSpecRowsAhead = 28u;        // these records are read before anything else
CANDELA_CONST uint kSpecOcclusion = 60u;        // for rays alone: any hit instead of the closest
// This id and the next nine are kinds and flags of the slots in the uniform buffer, four per word, a byte each.
CANDELA_CONST uint kSpecUniformKinds = 70u;
CANDELA_CONST uint kUniformKindWords = 10u;

CANDELA_CONST uint kStructureNone = 0u;  // brute force
CANDELA_CONST uint kStructureGrid = 1u;
CANDELA_CONST uint kStructureBvh = 2u;      // binary
CANDELA_CONST uint kStructureWideBvh = 3u;  // 8-wide, compressed
CANDELA_CONST uint kLensNone = 0u;
CANDELA_CONST uint kLensDisc = 1u;
CANDELA_CONST uint kLensSquare = 2u;
CANDELA_CONST uint kFilterBox = 0u;
CANDELA_CONST uint kFilterTent = 1u;
CANDELA_CONST uint kFilterNone = 2u;  // rays pass through the pixels' origins
CANDELA_CONST uint kFilterGaussian = 3u;
CANDELA_CONST uint kSamplerIndependent = 0u;
CANDELA_CONST uint kSamplerStratified = 1u;
CANDELA_CONST uint kSamplerSobol = 2u;
CANDELA_CONST uint kBackdropEnvironment = 0u;  // camera rays see the background that lights the scene
CANDELA_CONST uint kBackdropColour = 1u;
CANDELA_CONST uint kBackdropNone = 2u;  // the film counts the samples that hit something
CANDELA_CONST uint kCoincidentSphere = 1u << kKindSphere;
CANDELA_CONST uint kCoincidentTriangle = 1u << kKindTriangle;
CANDELA_CONST uint kCoincidentBox = 1u << kKindBox;
CANDELA_CONST uint kCoincidentCone = 1u << kKindCone;
CANDELA_CONST uint kCoincidentPlane = 1u << kKindPlane;
CANDELA_CONST uint kCoincidentTransmits = 1u << 8u;  // light crosses some of them
CANDELA_CONST uint kCoincidentEmitters = 1u << 9u;   // some emitter coincides with another one
CANDELA_CONST uint kViewNone = 0u;                   // an image of light
CANDELA_CONST uint kViewAo = 1u;
CANDELA_CONST uint kViewNormal = 2u;
CANDELA_CONST uint kViewAlbedo = 3u;
CANDELA_CONST uint kViewDepth = 4u;
CANDELA_CONST uint kViewId = 5u;
CANDELA_CONST uint kViewCost = 6u;

// The device: host/trace/device/code_form.h.
CANDELA_CONST uint kSpecMasksLanes = 103u;
CANDELA_CONST uint kSpecLimitsLoops = 104u;

CANDELA_END
#endif
