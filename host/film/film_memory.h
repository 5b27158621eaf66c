// Refuses films that this machine cannot hold.
#pragma once
#include "host/render/extent.h"

namespace candela::film {

/// Throws OutOfMemoryError, as requireMemory() does, if a film of this size exceeds the memory budget.
void requireMemoryForFilm(const render::Extent& size);

}  // namespace candela::film
