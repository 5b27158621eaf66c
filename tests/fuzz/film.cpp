// The reader of film files.
#include "host/job/film/film_file.h"
#include "tests/fuzz/fuzz.h"

void candela::fuzz::run(Input input) {
  expectErrors([&] {
    film::FilmReader reader(fileOf(input));
    film::readFilm(reader);
  });
}
