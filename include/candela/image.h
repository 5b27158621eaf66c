// Pictures: means of a film, image files, and the difference between two pictures.
//
//   candela::writeImage("room.png", candela::toImage(film), {});
//
// Pixels are linear RGB of Rec. 709, row by row from the top, premultiplied where there is alpha. A display transform
// (exposure in stops, tone curve, sRGB) applies only to formats of 8 bits.
#pragma once
#include "host/image/image.h"
#include "host/image/metrics.h"

namespace candela {

using image::Image;
/// The means of a film with variances and numbers of samples.
using image::toImage;
/// Add what a film has besides: alpha, and layers such as albedo, normal and depth.
using image::addAlpha;
using image::addLayers;

/// PNG, JPEG, HDR, PFM, EXR and WebP (reading only). Writing is atomic. Both throw FileError, and writeImage()
/// UsageError for another extension.
using image::DisplayTransform;
using image::readImage;
using image::ToneMap;
using image::writeImage;

/// Means, MSE, relative MSE, PSNR (dB) and the largest difference of two images. Throws UsageError if the sizes differ.
using image::compareImages;
using image::ImageComparison;

}  // namespace candela
