// Results of the kernel that replays one sample: all that the sample's path computed, in 16-byte records. In records of
// words, floats are stored as their bits.
#ifndef CANDELA_SHARED_TRACE_ROWS_H
#define CANDELA_SHARED_TRACE_ROWS_H
#include "language.h"
CANDELA_BEGIN

// Maximum number of a path's vertices that are stored; of longer paths, the first ones are.
CANDELA_CONST uint kTracedVertices = 64u;

// Stages of the estimator that a vertex went through. The records of other stages are undefined.
CANDELA_CONST uint kTracedHit = 1u;        // the ray hit something
CANDELA_CONST uint kTracedOutside = 2u;    // the ray arrives on the side to which the primitive's own normal points
CANDELA_CONST uint kTracedEmission = 4u;   // the surface emits towards the ray
CANDELA_CONST uint kTracedLight = 8u;      // a light was chosen
CANDELA_CONST uint kTracedScatter = 16u;   // a direction was sampled, and it is above the surface
CANDELA_CONST uint kTracedRoulette = 32u;  // Russian roulette was played
CANDELA_CONST uint kTracedSurvived = 64u;  // the path survived it

// One vertex, 16 records: from the arriving ray to the choice of the next one.
struct TracedVertex {
  vec4 originDistance;     // of the ray; distance to the hit
  vec4 directionPdf;       // of the ray; 0: delta
  uvec4 throughputStages;  // of the ray; kTraced... of the vertex
  uvec4 positionPrimitive;
  uvec4 normalMaterial;  // geometric normal on the ray's side; index in Scene::materials
  uvec4 shadingNormalLobe;
  vec4 emissionWeight;          // emission times its MIS weight; that weight
  vec4 lightDirectionDistance;  // of the shadow ray
  uvec4 lightEntry;             // entry of the light table, primitive (kRecordMiss: a point light), kShadow..., 0
  vec4 lightDensities;          // pdf of the light sample with the choice, pdf of the BSDF for it, MIS weight, 0
  vec4 lightRadiance;           // contribution of the light sample before the throughput; 0
  vec4 nextDirectionPdf;        // 0: delta
  vec4 weightSurvival;          // f |cos| / pdf of the next direction; survival probability of roulette
  vec4 radiance;                // of the path so far, this vertex included; 0
  uvec4 lightNumbers;           // words of light choice, light u, light v, lobe
  uvec4 bsdfNumbers;            // words of BSDF u, BSDF v, roulette, spare
};

// Follows the Counters of the results buffer.
struct TracedSample {
  uvec4 cameraNumbers;  // words of filter x, filter y, lens u, lens v
  uvec4 radianceCount;  // the sample's value; vertices of the path, stored or not. All 0 until the path has ended
  TracedVertex vertices[kTracedVertices];
};

CANDELA_END
#endif
