// Pictures of films, and their comparison.
#include "host/app/view/picture.h"

#include <catch2/catch.hpp>

using namespace candela;
using namespace candela::view;

TEST_CASE("a picture has the means and the counts of a film, and keeps pixels without samples") {
  image::Film film(3, 2);
  film.addSample(1, 0, {0.5, 1, 2}, 0);
  film.addSample(1, 0, {1.5, 1, 4}, 1);
  Picture picture({3, 2});
  picture.pixels[5] = {7, 8, 9, 1};
  show(film, picture);
  CHECK(picture.at(1, 0) == glm::vec4(1, 1, 3, 2));
  CHECK(picture.at(0, 0) == glm::vec4(0));
  CHECK(picture.at(2, 1) == glm::vec4(7, 8, 9, 1));
}

TEST_CASE("a film of a lower resolution covers the picture, marked by its scale") {
  image::Film film(2, 1);
  film.addSample(0, 0, {1, 0, 0}, 0);
  film.addSample(1, 0, {0, 1, 0}, 0);
  Picture picture({4, 2});
  show(film, picture);
  for (std::uint32_t y = 0; y < 2; ++y) {
    CHECK(picture.at(1, y) == glm::vec4(1, 0, 0, -2));
    CHECK(picture.at(2, y) == glm::vec4(0, 1, 0, -2));
  }
}

TEST_CASE("pictures are compared where they have equal numbers of samples") {
  Picture a({4, 1}), b({4, 1});
  a.pixels = {{1, 1, 1, 4}, {2, 2, 2, 4}, {3, 3, 3, 4}, {9, 9, 9, -2}};
  b.pixels = {{1, 1, 1, 4}, {2.5, 2.5, 2.5, 4}, {0, 0, 0, 3}, {1, 1, 1, -2}};
  const PictureDifference difference = compare(a, b);
  CHECK(difference.pixels == 2);
  CHECK(difference.unequal == 1);
  CHECK(difference.meanA == Approx(1.5));
  CHECK(difference.meanB == Approx(1.75));
  CHECK(difference.worst == glm::uvec2(1, 0));
  CHECK(difference.worstDifference == Approx(-0.5));
}

TEST_CASE("values are equal within 1e-4 of the larger one, in each channel") {
  Picture a({2, 1}), b({2, 1});
  a.pixels = {{1, 1, 1, 1}, {1, 1, 1, 1}};
  b.pixels = {{1, 1, 1.00009f, 1}, {1, 1, 1.00011f, 1}};
  CHECK(compare(a, b).unequal == 1);
}
