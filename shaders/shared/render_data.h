// Data that the host and the kernels exchange besides the scene: constants, push constants, path states, film and
// counters.
#ifndef CANDELA_SHARED_RENDER_DATA_H
#define CANDELA_SHARED_RENDER_DATA_H
#include "../../lists/lobes.h"
#include "language.h"
CANDELA_BEGIN

// Constants of a render. Each 16 bytes contain a vector of three and a scalar, or scalars and pairs, so that std140 and
// C++ give every member the same offset.
struct RenderConstants {
  vec3 cameraOrigin;
  float pixelOriginX;         // position within its pixel of a ray without jitter, horizontal
  vec3 cameraForward;         // -d n, from the eye to the view plane's centre
  float pixelOriginY;         // vertical
  vec3 cameraRight;           // w u, the width of the view plane
  float inversePixelsAcross;  // 1 / pixels across the view
  vec3 cameraUp;              // h v
  float inversePixelsDown;    // 1 / pixels down the view
  vec3 lensRight;             // a u
  float inverseFocal;         // 1 / focal
  vec3 lensUp;                // a v
  uint firstSurfaceRow;       // first record of the parameters of surfaces
  vec3 background;
  float aoDistance;  // maximum distance of ambient occlusion rays
  uint imageWidth;   // pixels of the film
  uint imageHeight;
  uint seed;
  uint strataPerSide;  // n of the n x n strata; 0: none
  uint maxDepth;
  uint rouletteStart;  // Russian roulette is played at greater depths
  uint lightCount;
  uint stateRows;          // 16-byte records of a pixel's state; Whitted tracer only
  uint firstStructureRow;  // first record of a BVH's nodes or of a grid's cells
  uint firstPrimitiveRow;
  uint firstMaterialRow;
  uint firstLightRow;
  uint firstGeometryRow;
  uint firstSkyRow;
  uint firstPlaneSlot;  // infinite planes come after all other primitives
  uint slotCount;
  vec3 gridLow;         // lower corner
  float gridReach;      // the grid's largest coordinate in magnitude
  vec3 gridHigh;        // upper corner
  uint firstEnergyRow;  // first record of the energy tables
  vec3 gridScale;       // cells per unit of length, 0 on axes of one cell
  uint firstTextureRow;
  vec3 gridWidth;                // size of a cell
  float indirectLimit;           // maximum of a contribution of light that was scattered twice or more
  uvec3 gridSides;               // cells along each axis
  uint firstItemRow;             // first record of the grid's items
  uvec3 gridStrides;             // the index of cell (x, y, z) is dot(gridStrides, (x, y, z))
  float environmentProbability;  // of choosing the environment from the light table; 0 if it is not in it
  vec3 environmentX;             // axes of the environment's map
  uint environmentWidth;         // texels
  vec3 environmentY;
  uint environmentHeight;
  vec3 environmentZ;
  uint firstEnvironmentRow;  // first record of the texels
  uint firstInstanceRow;
  uint topNode;  // the root of the BVH over instances
  uint firstAttributeRow;
  uint firstLightTreeRow;  // its header
  vec2 environmentSize;    // texels
  float environmentPole;   // offset of the poles from the upper and the lower edge of the map, in rows
  float environmentRows;   // between the poles
};

// Maximum number of primitives, and of their records, that the uniform buffer holds for small scenes: see
// traversal.glsl.
CANDELA_CONST uint kMaxUniformSlots = 40u;
CANDELA_CONST uint kUniformRows = 120u;

// Uniform buffer of a render, std140.
struct RenderUniforms {
  RenderConstants constants;
  uvec4 slotRows[kUniformRows];
};

// Push constants of a dispatch.
struct DispatchConstants {
  uvec2 regionOrigin;  // pixels of the image
  uvec2 regionSize;
  uint firstRow;       // first row of the image in the band
  uint maxSegments;    // path segments per invocation
  uint sampleEnd;      // end of the range of sample indices
  uint maxIterations;  // loop iterations per invocation
  uint roundParity;    // wavefront only: index of the round modulo 2
  uint bandPixels;     // pixels of the band
  uint firstColumn;    // column of the image at which the film begins
};

// Work of a pixel's paths so far. Each count wraps at 2^32.
struct PathCounts {
  uint bounceRays;
  uint shadowRays;
  uint vertices;
  uint steps;  // traversal steps
};

// A path between two dispatches: one per pixel of the band, 96 bytes, floats as their bits. All zero: no sample has
// started. path_state.glsl has macros that name the packed members.
struct PathState {
  uvec4 originPdf;         // ray origin, pdf of its direction (0: delta)
  uvec4 directionAndSlot;  // ray direction, originSlot (slot of the origin primitive and flags, or kNoSlot)
  uvec4 throughputDepth;   // rgb, depth of the ray (0: the sample has not started) | volume << kVolumeShift
  uvec4 radianceSample;    // rgb, sample index
  PathCounts counts;
  uvec4 instances;  // numbers of instances, or 0: of the ray's origin; in a WaveState, of the hit and of the shadow
                    // ray's origin, too; then what Path::receiver is, or 0
};

// Length of a pixel's list of hits. The host reads the lists after this number of samples.
CANDELA_CONST uint kListedHits = 32u;
// Entry of a sample whose path has only hit perfect mirrors and glass so far.
CANDELA_CONST uint kSeenThrough = 0xfffffffeu;

CANDELA_CONST uint kVolumeShift = 21u;  // depths are at most 2^20

// A path of the wavefront, and the data that its stages pass on: 160 bytes.
struct WaveState {
  PathState path;
  uvec4 hit;          // of the path's ray: distance, slot, primitive index; once it has been shaded, the point of the
                      // light of the shadow ray; then the depth of the vertex shaded last
  uvec4 shadowLimit;  // of the shadow ray: origin, maximum distance
  uvec4 shadowDirection;  // of the shadow ray: direction, originSlot
  uvec4 shadowLight;      // its contribution if unoccluded, slot of the light
};

// Header of a queue of the wavefront: the number of workgroups of its stage, as vkCmdDispatchIndirect reads it, and the
// number of pending pixels.
struct QueueHeader {
  uint groupsX;
  uint groupsY;
  uint groupsZ;
  uint count;
};

// Indices of the queues: paths to extend in rounds of even index, shadow rays, paths that ended, and paths to extend in
// rounds of odd index. The queues that a round fills are consecutive. The headers, followed by the queues themselves
// with a word for each pixel of the band, are stored between the counters and the path records.
CANDELA_CONST uint kQueueExtendEven = 0u;
CANDELA_CONST uint kQueueShadow = 1u;
CANDELA_CONST uint kQueueRenew = 2u;
CANDELA_CONST uint kQueueExtendOdd = 3u;
CANDELA_CONST uint kQueueCount = 4u;

// Maximum number of workgroups along x, which every device supports. With as many along y, there is an invocation for
// each pixel of the largest band even if a workgroup has only one.
CANDELA_CONST uint kGroupsPerRow = 65535u;

// A tree of the Whitted tracer between two dispatches, floats as their bits: one per pixel of the band, followed by its
// pending rays. All zero: no sample has started.
struct TreeState {
  uvec4 originAndSlot;    // of the current ray: origin, originSlot
  uvec4 directionWeight;  // its direction, its weight in the sample
  uint node;              // of the current ray (0: the sample has not started)
  uint pending;           // depths that have a pending ray
  uint nextLight;
  uint nodesDone;
  uvec4 radianceSample;  // rgb, sample index
  uint cameraHits;       // camera rays that hit; this and the counts below wrap at 2^32
  uint reflectedRays;
  uint refractedRays;
  uint shadowRays;
  uint vertices;
  uint steps;           // traversal steps
  uint originInstance;  // of the current ray
  uint unused0;
};

CANDELA_CONST uint kTreeRows = 6u;

// Records of a pending refracted ray: its first two as in TreeState, and the instance of its origin. There is at most
// one for each depth from 2 on; they follow the TreeState in this order.
CANDELA_CONST uint kPendingRows = 3u;

// Maximum number of lights that a segment of the Whitted tracer tests, so that segments are short on devices that limit
// loops.
CANDELA_CONST uint kLightsPerSegment = 8u;

// Film, four records per pixel: see FilmPixel in host/image/film.h.
struct FilmRows {
  uvec4 red;               // sum, sample count
  uvec4 green;             // sum, bad count
  uvec4 blue;              // sum, 1 + first bad sample
  uvec4 luminanceSquared;  // sum, count of samples whose camera ray hit something (0 unless kCountsHits)
};

CANDELA_CONST uint kFilmRows = 4u;  // 16-byte records of a pixel

// After the film of all pixels of the band, the film buffer has kLayerRows records of layers per pixel, if it has any:
// image::LayerRow, shaders/layers.glsl. An invocation adds the layers of at most this number of samples.
CANDELA_CONST uint kMaxGatheredSamples = 1024u;

// Header of the results buffer.
struct Counters {
  uint finishedPixels;   // invocations that reached the end of their sample range
  uint truncated;        // loops that ended before their work was done
  uint finishedSamples;  // wraps: the host adds up differences
  uint volumeFaults;     // docs/light-transport.md section 5.6
};

// An originSlot is a slot and these flags.
CANDELA_CONST uint kOriginInward = 0x80000000u;      // the ray starts inward from its origin primitive
CANDELA_CONST uint kOriginCrosses = 0x40000000u;     // it crosses the surface; set if the origin primitive may coincide
CANDELA_CONST uint kOriginCoincident = 0x20000000u;  // with another one, which this flag says
CANDELA_CONST uint kOriginBeyond = 0x10000000u;      // the ray before hit it at once, when it went forth,
CANDELA_CONST uint kOriginBack = 0x08000000u;        // or back: docs/light-transport.md section 4
CANDELA_CONST uint kOriginSlotMask = 0x07ffffffu;

// Path records: kRecordedVertices pairs (primitive index, decisions) per pixel, after the counters.
CANDELA_CONST uint kRecordedVertices = 32u;
CANDELA_CONST uint kRecordMiss = 0xffffffffu;
// Decisions: valid | visible lights (Whitted: bit i mod 14 flips for light i) << 17 | roulette
// survived << 16 | shadow << 8 | lobe.
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
