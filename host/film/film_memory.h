// Refuses films that this machine cannot hold.
#pragma once
#include "host/render/extent.h"

namespace candela::film {

/// Throws OutOfMemoryError if a film of this size is larger than the machine's memory: it could be allocated, but would
/// make the machine swap.
void requireMemoryForFilm(const render::Extent& size);

}  // namespace candela::film
