// The colour spaces of FLIP.
#pragma once
#include <glm/glm.hpp>

namespace candela::image::flip {

/// Convert between linear Rec. 709 in [0, 1] and YyCxCz, a linear opponent space: Y from 0 to 100, red-green,
/// blue-yellow.
glm::dvec3 toOpponent(const glm::dvec3& linear);
glm::dvec3 fromOpponent(const glm::dvec3& opponent);

/// Converts linear Rec. 709 to CIELAB for D65 white, with a* and b* scaled by L*/100 (Hunt effect: dark colours look
/// less saturated).
glm::dvec3 toHuntLab(const glm::dvec3& linear);

/// Returns the HyAB distance (Abasi, Amani Tehran and Fairchild 2020): |dL| plus the Euclidean distance in the plane of
/// a and b.
double hyab(const glm::dvec3& a, const glm::dvec3& b);

/// Returns the error, in [0, 1], of two colours in Hunt-adjusted Lab.
double colourError(const glm::dvec3& a, const glm::dvec3& b);

}  // namespace candela::image::flip
