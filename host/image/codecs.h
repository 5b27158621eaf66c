// One encoder and one decoder per file format, between images and bytes in memory. Internal to the image layer.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "host/image/image.h"
#include "host/image/texels.h"

namespace candela::image {

using Bytes = std::vector<std::byte>;
using ByteView = std::span<const std::byte>;

/// Throws FileError unless 1 <= width, height <= kMaxImageSide and there are at most kMaxImagePixels. Decoders
/// call it before they allocate memory.
void checkImageSize(std::uint64_t width, std::uint64_t height);

/// Returns whether an ICC profile names sRGB in its texts, as those of sRGB do.
bool namesSrgb(ByteView profile);

/// Decoders accept any bytes and throw FileError, without the name of the file, if they are not an image.
Texels decodePng(ByteView file);
Texels decodeJpeg(ByteView file);
Texels decodeWebp(ByteView file);
Texels decodeBmp(ByteView file);
Texels decodeTga(ByteView file);
Image decodeHdr(ByteView file);
Image decodePfm(ByteView file);
Image decodeExr(ByteView file, ImageParts parts);

/// TGA files have no first bytes of their own: returns whether the header can be that of one.
bool looksLikeTga(ByteView file);

/// Encoders require images that pass checkImageSize.
Bytes encodePng(const Pixels8& pixels);
Bytes encodeJpeg(const Pixels8& pixels);
Bytes encodeHdr(const Image& image);
Bytes encodePfm(const Image& image);
Bytes encodeExr(const Image& image);

}  // namespace candela::image
