// Compares the size of a film with the memory that there is.
#include "host/job/film/film_memory.h"

#include <fmt/format.h>

#include "host/base/memory_budget.h"
#include "host/image/film.h"

namespace candela::film {

void requireMemoryForFilm(const render::Extent& size, image::LayerSet layers) {
  const std::uint64_t layerBytes = image::layerRowCount(image::layerSumsOf(layers)) * sizeof(image::LayerRow);
  requireMemory(fmt::format("an image of {}x{} pixels", size.width, size.height),
                std::uint64_t{size.width} * size.height * (sizeof(image::FilmPixel) + layerBytes),
                "use a machine with more memory");
}

}  // namespace candela::film
