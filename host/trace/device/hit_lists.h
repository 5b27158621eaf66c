// Counts the ids of a device's lists of hits.
#pragma once
#include <cstdint>
#include <span>

#include "host/image/film.h"
#include "host/scene/object_names.h"

namespace candela::device {

/// Adds the samples of a film's rows, from `firstRow` on, that its mattes lack. `lists` has kListedHits primitives for
/// each pixel, by sample index modulo kListedHits. No pixel may lack more samples than that. `firstSample` is the index
/// of the first sample of each pixel.
void addListedHits(std::span<const std::uint32_t> lists, std::uint32_t firstRow, std::uint32_t firstSample,
                   const scene::MatteIds& ids, image::Film& film);

}  // namespace candela::device
