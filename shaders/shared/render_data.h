// What host and kernel exchange besides the scene: constants, push constants, path states, film and counters.
#ifndef CANDELA_SHARED_RENDER_DATA_H
#define CANDELA_SHARED_RENDER_DATA_H
#include "features.h"
#include "language.h"
CANDELA_BEGIN

// One per render. A vector of three and a scalar, or four scalars, fill 16 bytes: so std140 and C++ give every member the
// same offset.
struct RenderConstants {
  vec3 cameraOrigin;
  float pixelOriginX;        // position within its pixel of a ray that is not jittered, across
  vec3 cameraForward;        // -d n, from the eye to the view plane's centre
  float pixelOriginY;        // down
  vec3 cameraRight;          // w u, the width of the view plane
  float inversePixelsAcross; // 1 / pixels across the view
  vec3 cameraUp;             // h v
  float inversePixelsDown;   // 1 / pixels down the view
  vec3 lensRight;            // a u
  float inverseFocal;        // 1 / focal
  vec3 lensUp;               // a v
  float unused0;
  vec3 background;
  float aoDistance;          // length of ambient occlusion's rays
  uint imageWidth;           // pixels
  uint imageHeight;
  uint seed;
  uint strataPerSide;        // n of the n x n strata; 0: none
  uint maxDepth;
  uint rouletteStart;        // Russian roulette is played at greater depths
  uint lightCount;
  uint stateRows;            // 16-byte records of a pixel's state; Whitted's tracer only
  uint firstStructureRow;    // of a BVH's nodes or of a grid's cells
  uint firstPrimitiveRow;
  uint firstMaterialRow;
  uint firstLightRow;
  uint firstNormalRow;
  uint firstSkyRow;
  uint firstPlaneSlot;       // infinite planes are behind all other primitives
  uint slotCount;
  vec3 gridLow;              // lower corner
  float gridReach;           // the grid's largest coordinate in magnitude
  vec3 gridHigh;             // upper corner
  float unused1;
  vec3 gridScale;            // cells per unit of length, 0 on axes of one cell
  float unused2;
  vec3 gridWidth;            // of a cell
  float unused3;
  uvec3 gridSides;           // cells along each axis
  uint firstItemRow;         // of the grid's items
  uvec3 gridStrides;         // the index of cell (x, y, z) is dot(gridStrides, (x, y, z))
  uint unused4;
};

// Of a scene with so few primitives, their rows are in the uniform buffer too: see traversal.glsl.
CANDELA_CONST uint kMaxUniformSlots = 40u;
CANDELA_CONST uint kUniformRows = 120u;

// One per render, uniform buffer, std140.
struct RenderUniforms {
  RenderConstants constants;
  uvec4 slotRows[kUniformRows];
};

// One per dispatch, push constants.
struct DispatchConstants {
  uvec2 regionOrigin;  // in pixels of the image
  uvec2 regionSize;
  uint firstRow;       // row of the image at which the band begins
  uint maxSegments;    // path segments per invocation
  uint sampleEnd;      // end of the range of sample indices
  uint maxIterations;  // loop iterations per invocation
  uint roundParity;    // wavefront only: the round's number modulo 2
  uint bandPixels;     // wavefront only: pixels of the band
};

// Work of a pixel's paths so far; each count wraps at 2^32.
struct PathCounts {
  uint bounceRays;
  uint shadowRays;
  uint vertices;
  uint steps;  // of traversals
};

// A path between two dispatches; one per pixel of the band, 80 bytes, floats as their bits. All zero: no sample started.
struct PathState {
  uvec4 originPdf;         // ray origin, pdf of its direction (0: delta)
  uvec4 directionLeaving;  // ray direction, leaving (slot | kLeavingInward, or kNoSlot)
  uvec4 throughputDepth;   // rgb, depth of the ray (0: the sample has not begun)
  uvec4 radianceSample;    // rgb, sample index
  PathCounts counts;
};

// The same for the wavefront, and what its stages hand on to each other: 144 bytes.
struct WaveState {
  PathState path;
  uvec4 hit;            // of the path's ray: distance, slot, primitive index; depth of the vertex that was shaded last
  uvec4 shadowLimit;    // of the shadow ray: origin, limit
  uvec4 shadowLeaving;  // its direction, leaving
  uvec4 shadowLight;    // what it brings, slot of the light
};

// A queue of the wavefront: how many workgroups its stage is to have, as vkCmdDispatchIndirect reads it, and the number
// of pixels that wait in it.
struct QueueHead {
  uint groupsX;
  uint groupsY;
  uint groupsZ;
  uint count;
};

// Paths to be extended in rounds of even number, shadow rays, paths that ended, and paths to be extended in rounds of odd
// number: what a round fills stands in a row. Heads, then the queues themselves, with a word for each pixel of the band,
// stand between the counters and the path records.
CANDELA_CONST uint kQueueExtendEven = 0u;
CANDELA_CONST uint kQueueShadow = 1u;
CANDELA_CONST uint kQueueRenew = 2u;
CANDELA_CONST uint kQueueExtendOdd = 3u;
CANDELA_CONST uint kQueueCount = 4u;

// A stage's workgroups stand in rows of so many, the most that every device allows: 65,535 rows have a lane for each pixel of
// the largest band even if a workgroup has but one.
CANDELA_CONST uint kGroupsPerRow = 65535u;

// A tree of Whitted's between two dispatches, floats as their bits; one per pixel of the band, with the rays behind it
// that wait. All zero: no sample started.
struct TreeState {
  uvec4 originLeaving;    // of the ray at hand: origin, leaving
  uvec4 directionWeight;  // its direction, weight in the pixel
  uint node;              // of the ray at hand (0: the sample has not begun)
  uint waiting;           // depths that have a waiting ray
  uint nextLight;
  uint nodesDone;
  uvec4 radianceSample;   // rgb, sample index
  uint cameraHits;        // camera rays that hit; this and the counts below wrap at 2^32
  uint reflectedRays;
  uint refractedRays;
  uint shadowRays;
  uint vertices;
  uint steps;             // of traversals
  uint unused0;
  uint unused1;
};

CANDELA_CONST uint kTreeRows = 6u;

// Refracted rays that wait, at most one for each depth from 2 on: in that order behind the TreeState, as its first two rows.
CANDELA_CONST uint kWaitingRows = 2u;

// So many lights Whitted's tracer asks at a time: a segment is as short on a device whose loops are limited.
CANDELA_CONST uint kLightsPerSegment = 8u;

// Film, four rows a pixel: see FilmPixel in host/image/film.h.
struct FilmRows {
  uvec4 red;               // sum, sample count
  uvec4 green;             // sum, bad count
  uvec4 blue;              // sum, 1 + first bad sample
  uvec4 luminanceSquared;  // sum, 0
};

// Head of the results buffer.
struct Counters {
  uint finishedPixels;  // lanes that reached the end of their sample range
  uint truncated;       // loops that ended before their work was done
  uint finishedSamples; // wraps: the host adds up differences
  uint unused;
};

CANDELA_CONST uint kLeavingInward = 0x80000000u;

// Path records: kRecordedVertices pairs (primitive index, decisions) a pixel behind the counters.
CANDELA_CONST uint kRecordedVertices = 32u;
CANDELA_CONST uint kRecordMiss = 0xffffffffu;
// Decisions: valid | visible lights (Whitted: bit i mod 14 flips for light i) << 17 | roulette survived << 16 | shadow << 8 |
// lobe.
CANDELA_CONST uint kRecordValid = 0x80000000u;
CANDELA_CONST uint kRecordedLights = 14u;
CANDELA_CONST uint kRecordLightShift = 17u;
#define CANDELA_DECLARE_LOBE(lobe, name, value) CANDELA_CONST uint name = value;
CANDELA_LOBES(CANDELA_DECLARE_LOBE)
#undef CANDELA_DECLARE_LOBE
CANDELA_CONST uint kShadowNotTraced = 0u;
CANDELA_CONST uint kShadowVisible = 1u;
CANDELA_CONST uint kShadowOccluded = 2u;

CANDELA_END
#endif
