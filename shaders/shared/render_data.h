// What host and kernel exchange besides the scene: constants, push constants, path states, film and counters.
#ifndef CANDELA_SHARED_RENDER_DATA_H
#define CANDELA_SHARED_RENDER_DATA_H
#include "language.h"
CANDELA_BEGIN

// Of a scene with so few primitives, their rows are in the uniform buffer too: see traversal.glsl.
CANDELA_CONST uint kMaxUniformSlots = 16u;
CANDELA_CONST uint kUniformRows = 48u;

// One per render, uniform buffer, std140.
struct RenderConstants {
  vec4 cameraOrigin;      // xyz
  vec4 cameraForward;     // xyz: -d n, from the eye to the view plane's centre
  vec4 cameraRight;       // xyz: w u, the width of the view plane; w: 1 / pixels across
  vec4 cameraUp;          // xyz: h v; w: 1 / pixels down
  vec4 lensRight;         // xyz: a u; w = 1 / focal
  vec4 lensUp;            // xyz: a v
  vec4 background;        // rgb; w: reach of ambient occlusion
  uvec4 imageSeed;        // width, height, seed, strata per side n (0: none)
  uvec4 limits;           // max depth, roulette start, light count, 0
  uvec4 sections;         // first row of nodes, primitives, materials, lights
  uvec4 moreSections;     // first row of normals, first row of sky, first plane slot, end of slots
  uvec4 slotRows[kUniformRows];
};

// One per dispatch.
struct DispatchConstants {
  uvec4 region;   // x, y, width, height in pixels of the image
  uvec4 work;     // first image row of the band, segments per lane, end of the sample range, loop turns per lane
};

// A path between two dispatches; one per pixel of the band, 80 bytes, floats as their bits. All zero: no sample started.
struct PathState {
  uvec4 originPdf;         // ray origin, pdf of its direction (0: delta)
  uvec4 directionLeaving;  // ray direction, leaving (slot | kLeavingInward, or kNoSlot)
  uvec4 throughputDepth;   // rgb, depth of the ray (0: the sample has not begun)
  uvec4 radianceSample;    // rgb, sample index
  uvec4 counts;            // bounce rays, shadow rays, vertices, traversal steps; each wraps at 2^32
};

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
CANDELA_CONST uint kRecordValid = 0x80000000u;  // decisions: valid | roulette survived << 16 | shadow << 8 | lobe
CANDELA_CONST uint kLobeNone = 0u;
CANDELA_CONST uint kLobeDiffuse = 1u;
CANDELA_CONST uint kLobeGlossy = 2u;
CANDELA_CONST uint kLobeMirror = 3u;
CANDELA_CONST uint kLobeReflect = 4u;
CANDELA_CONST uint kLobeRefract = 5u;
CANDELA_CONST uint kShadowNotTraced = 0u;
CANDELA_CONST uint kShadowVisible = 1u;
CANDELA_CONST uint kShadowOccluded = 2u;

CANDELA_END
#endif
