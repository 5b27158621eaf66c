// What the kernel that replays one sample leaves behind: all that the sample's path computed, a row at a time. In rows
// of words a float stands as its bits.
#ifndef CANDELA_SHARED_TRACE_ROWS_H
#define CANDELA_SHARED_TRACE_ROWS_H
#include "language.h"
CANDELA_BEGIN

// So many of a path's vertices are kept; of longer paths the first ones.
CANDELA_CONST uint kTracedVertices = 64u;

// Stages of the estimator that a vertex went through; rows of the others hold nothing.
CANDELA_CONST uint kTracedHit = 1u;        // the ray hit something
CANDELA_CONST uint kTracedOutside = 2u;    // on the side to which the primitive's own normal points
CANDELA_CONST uint kTracedEmission = 4u;   // which emits towards the ray
CANDELA_CONST uint kTracedLight = 8u;      // a light was chosen
CANDELA_CONST uint kTracedScatter = 16u;   // a direction was chosen, and it is above the surface
CANDELA_CONST uint kTracedRoulette = 32u;  // roulette was played
CANDELA_CONST uint kTracedSurvived = 64u;  // and won

// One vertex, 16 rows: from the ray that arrives to the choice of the next one.
struct TracedVertex {
  vec4 originDistance;          // of the ray; distance to the hit
  vec4 directionPdf;            // of the ray; 0: delta
  uvec4 throughputStages;       // of the ray; kTraced... of the vertex
  uvec4 positionPrimitive;
  uvec4 normalMaterial;         // geometric normal on the ray's side; place in Scene::materials
  uvec4 shadingNormalLobe;
  vec4 emissionWeight;          // emission times its MIS weight; that weight
  vec4 lightDirectionDistance;  // of the shadow ray
  uvec4 lightPlace;             // entry of the light table, primitive (kRecordMiss: a point light), kShadow..., 0
  vec4 lightDensities;          // pdf of the light sample with the choice, pdf of the BSDF for it, MIS weight, 0
  vec4 lightRadiance;           // what the light sample adds, before the throughput; 0
  vec4 nextDirectionPdf;        // 0: delta
  vec4 weightSurvival;          // f |cos| / pdf of the next direction; probability to survive roulette
  vec4 radiance;                // of the path so far, this vertex included; 0
  uvec4 lightNumbers;           // words of light choice, light u, light v, lobe
  uvec4 bsdfNumbers;            // words of BSDF u, BSDF v, roulette, spare
};

// Behind the Counters of the results buffer.
struct TracedSample {
  uvec4 cameraNumbers;  // words of filter x, filter y, lens u, lens v
  uvec4 radianceCount;  // what the sample adds to the film; vertices of the path, kept or not. All 0 until it has ended
  TracedVertex vertices[kTracedVertices];
};

CANDELA_END
#endif
