// Input of the denoiser: statistics of the pixels of a film, and the constants of its method. docs/denoising.md.
#ifndef CANDELA_SHARED_DENOISE_DATA_H
#define CANDELA_SHARED_DENOISE_DATA_H
#include "language.h"
CANDELA_BEGIN

// The statistics of a pixel, 64 bytes. A variance is that of the mean, all channels together.
struct DenoisePixel {
  vec4 light;        // xyz: mean of the samples divided by the reflectance; w: number of samples, 0 if it is not filtered
  vec4 root;         // xyz: mean of the square roots of the samples, divided by that of the reflectance; w: its variance
  vec4 normal;       // xyz: mean normal; w: its variance
  vec4 reflectance;  // xyz: mean albedo, and 1 where nothing is hit; w: its variance
};

// Push constants, one for each dispatch. Rows are those of the buffer of pixels.
struct DenoiseConstants {
  uint width;
  uint rows;
  uint firstRow;  // the rows that are filtered
  uint endRow;
  uint firstResultRow;  // the row of the first pixel in the buffer of results
};

CANDELA_CONST uint kDenoiseWorkgroupSide = 8u;
CANDELA_CONST int kDenoiseRadius = 7;       // of the window of neighbours
CANDELA_CONST int kDenoisePatchRadius = 1;  // of the patches that the test compares

CANDELA_END
#endif
