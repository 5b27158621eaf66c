// The counts of ids of mattes as words of a film file. Internal to the film layer.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "host/job/film/film_channels.h"

namespace candela::film {

/// Returns the words of the pixels from `firstPixel` on: for each of them the slots of objects, then those of
/// materials, each an id and its count. Slots that are not used are 0.
std::vector<std::uint32_t> matteWords(const image::Film& film, std::size_t firstPixel, std::size_t pixels,
                                      const ChannelChoice& choice);

/// The counts of some pixels, by MatteKind; none for kinds that the film lacks.
using MatteRows = std::array<std::vector<image::IdCounts>, image::kMatteKinds.size()>;

/// Reads the words of matteWords(). Throws FileError unless the counts of each pixel are by rising ids, have names and
/// add up to its samples.
MatteRows mattesOf(std::span<const std::uint32_t> words, std::span<const image::FilmPixel> pixels,
                   const FilmHeader& header);

/// Returns FilmHeader::matteSlots of a film.
std::array<std::uint32_t, image::kMatteKinds.size()> slotsOf(const image::Film& film);

}  // namespace candela::film
