// The properties of images that LDR-FLIP compares.
#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "host/image/image.h"
#include "host/image/separable_filter.h"

namespace candela::image {

/// The properties of an image that FLIP compares.
struct Appearance {
  std::vector<glm::dvec3> colours;  ///< Hunt-adjusted Lab after the low-pass filter of the eye
  Plane edges;
  Plane points;
};

Appearance appearanceOf(const Image& image, double pixelsPerDegree);

}  // namespace candela::image
