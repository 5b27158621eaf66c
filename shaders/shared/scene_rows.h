// Layout of the scene on the device: one array of 16-byte records, in sections whose first indices are in
// RenderConstants. Floats are stored as their bits. In names of functions and constants, such a record is called a row,
// because "record" alone is a path record (render_data.h).
#ifndef CANDELA_SHARED_SCENE_ROWS_H
#define CANDELA_SHARED_SCENE_ROWS_H
#include "../../lists/energy_tables.h"
#include "../../lists/light_kinds.h"
#include "../../lists/primitive_kinds.h"
#include "../../lists/surface_parameters.h"
#include "../../lists/textures.h"
#include "language.h"
CANDELA_BEGIN

// Interior nodes of the binary BVH, four records: (min, reference) and (max, primitive count) of the left child, then
// of the right. If the count is 0, the reference is a node; otherwise it is the first of `count` primitive slots.
CANDELA_CONST uint kNodeRows = 4u;

// Nodes of the compressed 8-wide BVH (host/trace/accel/wide_bvh.h), five records: (origin, exponent of the step in
// x | y << 8 | z << 16, each biased by 127, | children that are nodes << 24) (first node of the block, first primitive
// slot, leaf mask, 0) and the indices of planes, a byte each, children 0 to 3 and 4 to 7: (low x, low y) (low z, high
// x) (high y, high z).
CANDELA_CONST uint kWideNodeRows = 5u;

// Cells of a grid, three per record: the starts of their items, and the end of the last cell's items. The items, which
// are slots of primitives, are in a separate section, four per record. Both are counted from 0.
CANDELA_CONST uint kCellsPerRow = 3u;
CANDELA_CONST uint kItemsPerRow = 4u;

// Primitives ("slots", in the order of the BVH's leaves or of the grid's cells, with infinite planes last), three
// records each. Triangles of instances come after the planes, once for all instances of a mesh and a material. Common
// to all kinds: w of record 1 is the primitive index in the scene, or for an instance that in the mesh; w of record 2
// is kind, flags and material (below).
//   sphere    (anchor, radius) (k, .) (light + 1, 0, 0, .)   see intersections.glsl
//   triangle  (p0, geometry) (p1, .) (p2, .)
//   box       (min, 0) (max, .) (0, 0, 0, .)
//   cone      (base, base radius) (apex, .) (apex radius, 0, 0, .)
//   plane     (point, 0) (unit normal, .) (0, 0, 0, .)
CANDELA_CONST uint kPrimitiveRows = 3u;
#define CANDELA_DECLARE_KIND(kind, feature, name, value, flag) CANDELA_CONST uint name = value;
CANDELA_PRIMITIVE_KINDS(CANDELA_DECLARE_KIND)
#undef CANDELA_DECLARE_KIND
CANDELA_CONST uint kKindMask = 7u;
CANDELA_CONST uint kFlagInsideOnly = 8u;     // sphere of negative radius
CANDELA_CONST uint kFlagTouched = 16u;       // the surface may contain a light: occlusion.glsl
CANDELA_CONST uint kFlagOpaque = 32u;        // T = 0: --one-sided applies
CANDELA_CONST uint kFlagTransparent = 128u;  // triangle that rays may pass
// Flags from here on are not among those that specialise the tests of small scenes.
CANDELA_CONST uint kFlagOrdered = 256u;  // its place in the order in a plane matters: docs/light-transport.md section 4
CANDELA_CONST uint kFlagCoincident = 2048u;  // another surface may coincide with it: coincidence.glsl
CANDELA_CONST uint kFlagTransmits = 4096u;   // rays may cross the surface
CANDELA_CONST uint kFlagThinWalled = 8192u;  // it bounds no volume
CANDELA_CONST uint kMaterialShift = 14u;
CANDELA_CONST uint kMaxMaterialCount = 1u << 18;

// Geometries, two records each: what is common to triangles of a mesh with one placement, which are lights or whose
// vertices have attributes: (flags, corners, normals, texture coordinates) (lit, lights, colours, tangents). `lit` is 0
// if they are no lights, and 1 if each is a light of its own. `corners` + i is the index of the corners of the triangle
// with the primitive index i, below, or without kGeometryIndexed, `corners` + 3 i is the vertex of the first of its
// corners, which the two others follow. `lights` + i is the index of the triangle in the light table + 1. If they are
// an instance that is one light, `lit` is its index in the table + 2, and `lights` + i is the triangle's number in its
// mesh. All sums are modulo 2^32, because the triangles do not begin with the primitive index 0. The others are the
// first records of arrays, counted from the beginning of the attributes. Geometry 0, all of which is 0, is that of
// triangles without lights and attributes.
CANDELA_CONST uint kGeometryRows = 2u;
CANDELA_CONST uint kGeometryNormals = 1u;  // the vertices have normals, and so on
CANDELA_CONST uint kGeometryTexCoords = 2u;
CANDELA_CONST uint kGeometrySecondTexCoords = 4u;  // set 1, besides set 0
CANDELA_CONST uint kGeometryColours = 8u;
CANDELA_CONST uint kGeometryTangents = 16u;
CANDELA_CONST uint kGeometryEmissionColours = 32u;  // the colours scale the emission
CANDELA_CONST uint kGeometryIndexed = 64u;

// Attributes, arrays with an element for each vertex of a mesh, which all of its geometries share: normals, a record
// (n, 0); texture coordinates of set 0, half a record, or of both sets, a record, with set 0 in x and y and set 1 in z
// and w; colours, a record of linear RGBA; tangents, a record (unit vector, handedness). Texture coordinates that a
// mesh lacks but its material needs are 0. Normals and tangents of instances are those of the mesh.
//
// Corners, the vertices of a triangle: three numbers of kCornerBits bits in two words, two triangles in a record. In
// scenes with a mesh of more than kMaxPackedVertices, all meshes have three words instead.
CANDELA_CONST uint kCornerBits = 21u;
CANDELA_CONST uint kMaxPackedVertices = 1u << kCornerBits;

// Instances (docs/light-transport.md section 4.1), eleven records. The first four are the columns of the placement, A
// and b, and the next three those of the normal matrix N; four more are those of the map from the scene to the space of
// the mesh, in which rays traverse its BVH. In w of the first four, in this order: the primitive index of the
// instance's first primitive; the node of the root of its BVH; and two numbers for the padding of rays, which is the
// first plus the second times the largest coordinate of a ray's origin.
CANDELA_CONST uint kInstanceRows = 11u;

// Materials of the path tracer, five records: (colour of the diffuse lobe, its weight) (colour of the glossy lobe, its
// weight) (emission, weight of the dielectric lobe) (exponent, ior, 1 if mirror, index of the surface parameters + 1,
// or 0) (colour of the dielectric or mirror lobe, the part of the glossy lobe's colour that base colour textures do not
// scale). The Whitted tracer stores Kd, Ks, and 1 for glass instead of the weights, the sum of emission and ambient
// term instead of the emission, and does not use the last record.
//
// A material that is a choice has (first material, second material, weight of the second or -1 for a choice by side, 0)
// as its first record, and kMaterialIsChoice in place of the number of surface parameters.
CANDELA_CONST uint kMaterialRows = 5u;
CANDELA_CONST uint kMaterialIsChoice = 0xffffffffu;

// Surface parameters, the records of CANDELA_SURFACE_RECORDS with the lanes that CANDELA_SURFACE_PARAMETERS states, and
// these: direction.x is the number of the volume that the surface bounds or 0, as a word; direction.z and w are cosine
// and sine of the rotation of the anisotropy; eta is the real part of a conductor's index of refraction, with 1 in w if
// the metal is a conductor, and kappa its imaginary part; plastic is (kPlastic..., reflectance for light from the
// inside, 1 if nonlinear, first record of its transmittances, counted from the first surface's), or of a bare interface
// (kInterface..., 0, 0, 0). The dispersion is 0 if there is none. The surfaces that bound volumes come first; the number
// of a volume is the index of its surface + 1.
struct SurfaceRecords {
#define CANDELA_DECLARE_RECORD(record, name, index, isLoaded) vec4 record;
  CANDELA_SURFACE_RECORDS(CANDELA_DECLARE_RECORD)
#undef CANDELA_DECLARE_RECORD
};
#define CANDELA_DECLARE_RECORD(record, name, index, isLoaded) CANDELA_CONST uint name = index;
CANDELA_SURFACE_RECORDS(CANDELA_DECLARE_RECORD)
#undef CANDELA_DECLARE_RECORD
#define CANDELA_COUNT_RECORD(record, name, index, isLoaded) +1u
CANDELA_CONST uint kSurfaceRows = CANDELA_SURFACE_RECORDS(CANDELA_COUNT_RECORD);
#undef CANDELA_COUNT_RECORD
CANDELA_CONST uint kMaxVolumeCount = 2047u;
CANDELA_CONST uint kPlasticNone = 0u;
CANDELA_CONST uint kPlasticSmooth = 1u;
CANDELA_CONST uint kPlasticGgx = 2u;
CANDELA_CONST uint kPlasticBeckmann = 3u;
CANDELA_CONST uint kInterfaceSmooth = 4u;
CANDELA_CONST uint kInterfaceGgx = 5u;
CANDELA_CONST uint kInterfaceBeckmann = 6u;

// Transmittances of the rough boundaries of plastic, after the surfaces: for each surface 21 records, whose four values
// are those at consecutive nodes of scene::Plastic. The last value of a record is the first of the next one.
CANDELA_CONST uint kPlasticCells = 63u;
CANDELA_CONST uint kPlasticCellsPerRow = 3u;

// Number of cells of the energy tables in each dimension.
#define CANDELA_DECLARE_CELLS(nodes, cells, count) CANDELA_CONST uint cells = count - 1u;
CANDELA_ENERGY_TABLES(CANDELA_DECLARE_CELLS)
#undef CANDELA_DECLARE_CELLS

// Energy tables, two records for every cell of the tables' nodes, in the order of the cells' lower nodes: the values at
// the nodes (i, j), (i + 1, j), (i, j + 1), (i + 1, j + 1) of energy::kWhite, and those of energy::kTilt.
CANDELA_CONST uint kEnergyRows = 2u;

// Glass tables, if the scene has volumes: after the energy tables, a record of four values as above for every cell of
// the cosines and roughnesses, for every node of the index of refraction; those of energy::kGlassOutside, then of
// energy::kGlassInside.

// Sheen table, if the scene has a sheen: after the tables before it, a record of four values as above for every cell of
// energy::kSheen.

// Tables of anisotropic microfacets, if the scene has any: after the tables before them, a record of four values as
// above for every cell of the cosines and azimuths, for every node of the roughness, for every node of the strength;
// those of energy::kAnisotropicWhite, then of energy::kAnisotropicTilt.

// Tables of anisotropic glass, if the scene has volumes, too: after those, for every node of the index of refraction,
// such a table of energy::kAnisotropicGlassOutside, then of energy::kAnisotropicGlassInside.

// Lights of the path tracer, three records: (threshold, probability, area, slot) (emission, colour or intensity, kind)
// (centre or position, radius). A directional light has the direction towards it as its position. A spot light has,
// instead of the area, the index of one more record among those that follow the last light:
// (direction, cosine of the outer angle); and instead of the radius 1 / (difference of the cosines). What the pdf of a
// triangle needs is in the first record.
CANDELA_CONST uint kLightRows = 3u;
#define CANDELA_DECLARE_KIND(kind, feature, name, value) CANDELA_CONST uint name = value;
CANDELA_LIGHT_KINDS(CANDELA_DECLARE_KIND)
#undef CANDELA_DECLARE_KIND
CANDELA_CONST uint kNoSlot = 0x07ffffffu;

// Light tree (docs/light-transport.md section 6.1), if the scene has one: a record (T, probability of the tree, number
// n of leaves, 0); then n leaves, then n - 1 inner nodes, the first of which is the root. Nodes have two records:
// (centre, radius) (power, axis and flags, cosine, next). Of a leaf, next is the index of its light; of an inner node,
// the first leaf m of the right range and flags: the left node is leaf or inner node m - 1, the right one leaf or inner
// node m. A light of the tree has its trail instead of its probability, and others have kNoTrail there if they are
// emitters.
//
// Trees of meshes have a record (0, first word of the trails of the mesh's triangles, number n of leaves, 0), and then
// nodes, of whose leaves next is the triangle. An instance that emits has six records: (column of A, component of b),
// three times; (row of M, factor of the rounding of n) (row of M, first record of the tree of its mesh) (row of M,
// first word of the slots of its triangles). Its light has the first of these records instead of the area, and kNoSlot.
// Words are counted from the first record of the scene, four in a record.
CANDELA_CONST uint kLightTreeHeaderRows = 1u;
CANDELA_CONST uint kLightNodeRows = 2u;
CANDELA_CONST uint kDirectionBits = 15u;  // of each of the two coordinates of a stored direction
CANDELA_CONST uint kDirectionMask = (1u << kDirectionBits) - 1u;
CANDELA_CONST uint kLightNodeCosine = 1u << 30;    // some light of the node emits by the cosine at its surface
CANDELA_CONST uint kLightNodeTwoSided = 1u << 31;  // some light of the node emits to both sides
CANDELA_CONST uint kLightNodeLeftLeaf = 1u << 30;
CANDELA_CONST uint kLightNodeRightLeaf = 1u << 31;
CANDELA_CONST uint kLightNodeMask = (1u << 30) - 1u;
CANDELA_CONST uint kNoTrail = 0xffffffffu;

// Lights of the Whitted tracer, which are all point lights in file order, four records: (colour, 0) (position, 0) and
// the edges of the square around the position that the light fills (edge, 0) (edge, 0).
CANDELA_CONST uint kPointLightRows = 4u;

// Textures, in scenes that have them: 64 records with the 256 linear values of 8-bit sRGB, or, in scenes with an image
// of 16 bits per channel, 16,384 records with the 65,536 linear values of 16-bit sRGB; then for each material four
// records with a word for each scene::TextureSlot, the first record of a reference counted from the beginning of the
// textures, or 0 for none, a record of its opacity (factor of alpha, cutoff or -1 for one that blends, reference,
// 0), and a record of scales (normal map, coat's normal map, kNormalMap... flags, 0); then the references; then the
// texels of the images, four in a record, r | g << 8 | b << 16 | a << 24, or two of 16 bits per channel, (r | g << 16,
// b | a << 16), each image beginning with a record. Words that refer to a reference of such an image have
// kDeepReference. References have two records: (x and y of rowS, width | height << 16, flags and first record of the
// image, counted from the beginning of the textures) (rowT, z of rowS). Kernels read the second only if the scene has
// the feature textureTransforms.
CANDELA_CONST uint kSrgbTableRows = 64u;
CANDELA_CONST uint kDeepSrgbTableRows = 16384u;
CANDELA_CONST uint kDeepReference = 1u << 31;
#define CANDELA_DECLARE_SLOT(slot, name, value) CANDELA_CONST uint name = value;
CANDELA_TEXTURE_SLOTS(CANDELA_DECLARE_SLOT)
#undef CANDELA_DECLARE_SLOT
#define CANDELA_COUNT_SLOT(slot, name, value) +1u
CANDELA_CONST uint kOpacityRow = (CANDELA_TEXTURE_SLOTS(CANDELA_COUNT_SLOT) + 3u) / 4u;  // of a material's records
#undef CANDELA_COUNT_SLOT
CANDELA_CONST uint kScaleRow = kOpacityRow + 1u;
CANDELA_CONST uint kMaterialTextureRows = kScaleRow + 1u;
CANDELA_CONST uint kNormalMapHeights = 1u;        // it is a bump map
CANDELA_CONST uint kNormalMapWithoutFacets = 2u;  // the normal is simply replaced
CANDELA_CONST uint kReferenceRows = 2u;
CANDELA_CONST uint kTextureSecondSet = 1u;  // flags, below the index of the record
CANDELA_CONST uint kTextureNearest = 2u;
CANDELA_CONST uint kTextureWrapShiftS = 2u;
CANDELA_CONST uint kTextureWrapShiftT = 4u;
CANDELA_CONST uint kTextureWrapMask = 3u;
#define CANDELA_DECLARE_WRAP(wrap, name, value) CANDELA_CONST uint name = value;
CANDELA_TEXTURE_WRAPS(CANDELA_DECLARE_WRAP)
#undef CANDELA_DECLARE_WRAP
CANDELA_CONST uint kTextureRowShift = 6u;
CANDELA_CONST uint kMaxTextureRows = 1u << 26;

// Sky: six records (width, height, first texel, 0), then 64 records with the 256 linear values of 8-bit sRGB, then the
// texels of all faces, four per record, each r | g << 8 | b << 16.
CANDELA_CONST uint kSkyFaceCount = 6u;
CANDELA_CONST uint kSkyTableRows = 64u;

// Environment: a record for each texel, row by row from the top (radiance, probability times the number of texels
// / (2 pi^2)), then a list of the ends of the intervals that choose a row, and for each row one of those that choose a
// column. A list has n records of four ends, with 2^32 - 1 in place of the last end and behind it, and n spans, two per
// record: the first and the last of the list's records that may have the first end above the numbers of the k-th of n
// equal parts.
CANDELA_CONST uint kEndsPerRow = 4u;
CANDELA_CONST uint kSpansPerRow = 2u;

CANDELA_END
#endif
