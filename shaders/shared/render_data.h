// What host and kernel exchange besides the scene: constants, push constants, path states, film and counters.
#ifndef CANDELA_SHARED_RENDER_DATA_H
#define CANDELA_SHARED_RENDER_DATA_H
#include "features.h"
#include "language.h"
CANDELA_BEGIN

// One per render.
struct RenderConstants {
  vec4 cameraOrigin;      // xyz; w: where in its pixel a ray goes that is not jittered, across
  vec4 cameraForward;     // xyz: -d n, from the eye to the view plane's centre; w: the same, down
  vec4 cameraRight;       // xyz: w u, the width of the view plane; w: 1 / pixels across the view
  vec4 cameraUp;          // xyz: h v; w: 1 / pixels down the view
  vec4 lensRight;         // xyz: a u; w = 1 / focal
  vec4 lensUp;            // xyz: a v
  vec4 background;        // rgb; w: reach of ambient occlusion
  uvec4 imageSeed;        // width, height, seed, strata per side n (0: none)
  uvec4 limits;           // max depth, roulette start, light count, rows of a pixel's state (Whitted only)
  uvec4 sections;         // first row of nodes or of a grid's cells, of primitives, materials, lights
  uvec4 moreSections;     // first row of normals, first row of sky, first plane slot, end of slots
  vec4 gridLow;           // xyz: the grid's lower corner; w: its largest coordinate in magnitude
  vec4 gridHigh;          // xyz
  vec4 gridScale;         // xyz: cells per unit of length, 0 on axes of one cell
  vec4 gridWidth;         // xyz: of a cell
  uvec4 gridSides;        // xyz: cells along each axis; w: first row of items
  uvec4 gridStrides;      // xyz: cell (x, y, z) is number dot(strides, (x, y, z))
};

// Of a scene with so few primitives, their rows are in the uniform buffer too: see traversal.glsl.
CANDELA_CONST uint kMaxUniformSlots = 40u;
CANDELA_CONST uint kUniformRows = 120u;

// One per render, uniform buffer, std140.
struct RenderUniforms {
  RenderConstants constants;
  uvec4 slotRows[kUniformRows];
};

// One per dispatch.
struct DispatchConstants {
  uvec4 region;   // x, y, width, height in pixels of the image
  uvec4 work;     // first image row of the band, segments per lane, end of the sample range, loop turns per lane; of the
                  // wavefront's stages: the same, the round's parity, the same, pixels of the band
};

// A path between two dispatches; one per pixel of the band, 80 bytes, floats as their bits. All zero: no sample started.
struct PathState {
  uvec4 originPdf;         // ray origin, pdf of its direction (0: delta)
  uvec4 directionLeaving;  // ray direction, leaving (slot | kLeavingInward, or kNoSlot)
  uvec4 throughputDepth;   // rgb, depth of the ray (0: the sample has not begun)
  uvec4 radianceSample;    // rgb, sample index
  uvec4 counts;            // bounce rays, shadow rays, vertices, traversal steps; each wraps at 2^32
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
  uvec4 place;            // its node (0: the sample has not begun), depths that have a waiting ray, next light, nodes done
  uvec4 radianceSample;   // rgb, sample index
  uvec4 rays;             // that hit from the camera, reflected, refracted, shadow; each wraps at 2^32
  uvec4 work;             // vertices, traversal steps, 0, 0
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
