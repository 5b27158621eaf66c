// Bounds of the rounding errors of a device that conforms to Vulkan.
#pragma once

namespace candela::reference {

/// Relative error of one correctly rounded operation in single precision.
inline constexpr double kRoundoff = 0x1p-24;

/// Bounds in units of kRoundoff, each the root of the sum of the squares of the bounds of the operations that compute
/// the quantity in `shaders/`. Vulkan's precision ("Precision and Operation of SPIR-V Instructions"): 1 for + - *, 5
/// for a division (2.5 ulp), 4 for inversesqrt, hence 6.4 for sqrt (1 / inversesqrt). docs/testing.md has the table.
struct RoundingBounds {
  double cameraDirection = 5;    ///< of a unit vector, per axis: three rounded axes of the view, products, sums, one
                                 ///< division
  double lensPoint = 5;          ///< relative, per axis
  double triangleTest = 6;       ///< of the farthest vertex: differences, shear (a division), products of coordinates
  double triangleWeights = 2.5;  ///< of the sum of the products of a triangle's weights; distances are rounded up by it
  double sphereTest = 4;         ///< of the distance to the anchor: differences, products, sums
  double boxTest = 6;            ///< of the farthest corner: differences, reciprocal of the direction
  double coneTest = 8;           ///< of the distance to the base plus the height: axis, products, sums
  double planeTest = 3;          ///< of the distance to the plane's point: difference, products, sums
  double hitDistance = 8;        ///< relative: quotient of the last step, between primitives at equal distances
  double position = 6;  ///< of the largest coordinate or distance: o + t d, put back onto the primitive, offset
  double normal = 3;    ///< of a unit vector, per axis, apart from the position's error
  double texCoord = 9;  ///< of the sum of the magnitudes of its terms and 1: interpolation (a division), transform
  double frame = 4;     ///< of a direction turned into or out of the shading frame, per axis
  double sampledDirection = 6;  ///< relative, per local axis: roots of the warps
  double lightDirection = 3;    ///< of a unit vector, per axis
  double lightDistance = 7;     ///< relative: a square root
  double lightDepth = 12;       ///< of the largest coordinate: distance of a light from a surface that it may touch
  double mapDirection = 8;      ///< of a unit vector, per axis: its coordinates in the environment's map
  double pdf = 12;              ///< relative: products and two divisions
  double bsdf = 12;             ///< relative
  double surface = 18;          ///< relative, f and pdf of surfaces: energy, distribution and visibility
  double sheen = 6;             ///< relative, of the quotient that sheen raises to a power
  double film = 0.1;            ///< relative, per nanometre of a thin film: product with the frequency, sums
  double importance = 14;       ///< relative, of a node of the light tree: squares, a division, products, the quotient
  double importanceCosine = 8;  ///< of a unit vector's product with another one, one of which was divided by its length
  double choice = 6;            ///< of a probability that a random number is compared with
  double lobeChoice = 14;       ///< of the probability of a surface's lobe: quotient of albedos
  double roughDirection = 16;   ///< of a direction sampled by microfacets, per axis, times alpha, besides `frame`
  double throughput = 8;        ///< relative: quotient of f and pdf
  double survival = 7;          ///< relative: a square root
  double radiance = 2;          ///< relative: a product and a sum
};
inline constexpr RoundingBounds kRoundingBounds{};

}  // namespace candela::reference
