// The channels of an EXR file beside the picture itself.
#pragma once
#include <OpenEXR/ImfHeader.h>

#include "host/image/exr_colours.h"
#include "host/image/image.h"

namespace candela::image {

/// Returns whether a channel belongs to the picture or to the statistics of a film, which are not layers: sums, counts
/// and variances of samples (docs/layers.md, docs/film-file.md).
bool isPictureOrStatistic(std::string_view name);

/// Adds the channels of the file's layers to the image, with room for `pixelCount` values each, except those that are
/// its picture. Integers and the ids of Cryptomatte are ids. Names of channels that do not have one value for each
/// pixel are added to `image.warnings`.
void addLayerChannels(const Imf::Header& header, const ExrColours& picture, std::size_t pixelCount, Image& image);

}  // namespace candela::image
