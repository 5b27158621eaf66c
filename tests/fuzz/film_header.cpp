// The description in a film file, which the target `film` does not reach because of its checksum.
#include "host/job/film/film_header.h"

#include "tests/fuzz/fuzz.h"

void candela::fuzz::run(Input input) {
  expectErrors([&] {
    const film::FilmHeader header = film::headerFromJson(textOf(input));
    if (film::headerFromJson(film::toJson(header)) != header) throw std::logic_error("not the same after writing");
  });
}
