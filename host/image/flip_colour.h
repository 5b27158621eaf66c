// The colour spaces of FLIP.
#pragma once
#include <glm/glm.hpp>

namespace candela::image::flip {

/// Linear Rec. 709 in [0, 1] to and from YyCxCz, a linear opponent space: Y 0 to 100, red-green, blue-yellow.
glm::dvec3 toOpponent(const glm::dvec3& linear);
glm::dvec3 fromOpponent(const glm::dvec3& opponent);

/// CIELAB of linear Rec. 709 for white D65, a* and b* scaled by L*/100 after Hunt: colours fade as light does.
glm::dvec3 toHuntLab(const glm::dvec3& linear);

/// HyAB distance (Abasi, Amani Tehran and Fairchild 2020): |dL| + the Euclidean distance in the plane of a and b.
double hyab(const glm::dvec3& a, const glm::dvec3& b);

/// Error in [0, 1] of two colours in Hunt-adjusted Lab.
double colourError(const glm::dvec3& a, const glm::dvec3& b);

}  // namespace candela::image::flip
