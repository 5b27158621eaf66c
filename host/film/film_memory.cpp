// Compares the size of a film with the memory of the machine.
#include "host/film/film_memory.h"

#include <fmt/format.h>

#include "host/core/errors.h"
#include "host/core/physical_memory.h"
#include "host/image/film.h"

namespace candela::film {

void requireMemoryForFilm(const render::Extent& size) {
  const double needed = static_cast<double>(size.width) * size.height * sizeof(image::FilmPixel);
  const double present = static_cast<double>(physicalMemory());
  if (needed <= present) return;
  constexpr double kGiB = 1024.0 * 1024 * 1024;
  throw OutOfMemoryError(fmt::format("an image of {}x{} pixels needs {:.1f} GiB; this machine has {:.1f} GiB",
                                     size.width, size.height, needed / kGiB, present / kGiB));
}

}  // namespace candela::film
