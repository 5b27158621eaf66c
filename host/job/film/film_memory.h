// Refuses films that this machine cannot hold.
#pragma once
#include "host/image/layers.h"
#include "host/trace/render/extent.h"

namespace candela::film {

/// Throws OutOfMemoryError, as requireMemory() does, if a film of this size with these layers exceeds the memory
/// budget.
void requireMemoryForFilm(const render::Extent& size, image::LayerSet layers);

}  // namespace candela::film
