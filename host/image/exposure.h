// The exposure of 8-bit images.
#pragma once
#include "host/image/image.h"

namespace candela::image {

/// Returns the exposure in stops that makes the geometric mean of the luminance 0.18, the reflectance of a grey card
/// (the key of Reinhard et al., "Photographic Tone Reproduction for Digital Images", SIGGRAPH 2002). Pixels whose
/// luminance is not positive and finite do not count; 0 if none does. From -64 to 64.
float automaticExposure(const Image& image);

}  // namespace candela::image
