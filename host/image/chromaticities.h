// Colour spaces of files that state their primaries.
#pragma once
#include <glm/glm.hpp>
#include <optional>

#include "host/image/image.h"

namespace candela::image {

/// CIE 1931 chromaticities x, y of the primaries and of the white point.
struct Chromaticities {
  glm::dvec2 red{0.64, 0.33}, green{0.30, 0.60}, blue{0.15, 0.06}, white{0.3127, 0.3290};  ///< those of Rec. 709
};

/// Returns the matrix from linear RGB of these primaries to Rec. 709. White stays (1, 1, 1): white points are adapted
/// by the Bradford transform (Lam 1985). Nothing if the chromaticities do not describe a colour space.
std::optional<glm::dmat3> toRec709(const Chromaticities& space);

/// Converts the colours of an image to Rec. 709. They keep their bits if the chromaticities differ from those of Rec.
/// 709 by at most 0.001. If the chromaticities do not describe a colour space, the image gets a warning instead.
void convertToRec709(const Chromaticities& space, Image& image);

}  // namespace candela::image
