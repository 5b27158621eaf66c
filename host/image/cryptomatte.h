// Mattes as channels and metadata of the Cryptomatte specification 1.2 (Friedman and Jones, 2015).
#pragma once
#include <array>
#include <map>
#include <span>
#include <string>

#include "host/image/film.h"
#include "host/image/mattes.h"

namespace candela::image {

/// The number of ids of a pixel in files: those with the maximum coverage.
inline constexpr std::size_t kMatteRanks = 6;

/// Returns the names of the channels of a layer, such as `CryptoObject00.r`: id and coverage of each rank, two ranks
/// for each four channels.
std::span<const std::string> cryptomatteChannelNames(MatteKind kind);

/// The values of the channels of a pixel, in the order of cryptomatteChannelNames().
using CryptomatteValues = std::array<float, 2 * kMatteRanks>;

/// Returns, for each rank, the bits of an id as a number and the fraction of the samples with the id; 0 for ranks that
/// the pixel lacks. Ranks are sorted by descending coverage, then by ascending id. Samples that hit nothing have no
/// rank.
CryptomatteValues cryptomatteValues(const IdCounts& counts);

/// Returns the metadata of a layer whose ids belong to these names.
std::map<std::string, std::string> cryptomatteMetadata(MatteKind kind, std::span<const std::string> names);

}  // namespace candela::image
