// Mattes in film files.
#include <catch2/catch.hpp>

#include "host/base/errors.h"
#include "host/job/film/merge.h"
#include "tests/base/temporary_folder.h"
#include "tests/job/film/made_films.h"

using namespace candela;
using namespace candela::film;
using image::MatteKind;

namespace {

const std::vector<std::string> kNames{"ball", "box", "cone", "floor"};

image::LayerSet matteLayers() {
  image::LayerSet layers;
  layers.add(image::Layer::cryptoObject);
  layers.add(image::Layer::cryptoMaterial);
  return layers;
}

// Returns the name of the object that a sample hits; nothing: it hits none.
std::optional<std::string> nameAt(std::uint32_t x, std::uint32_t y, std::uint32_t sample) {
  const std::uint32_t choice = (x + 3 * y + 5 * sample) % 7;
  return choice < kNames.size() ? std::optional(kNames[choice]) : std::nullopt;
}

// The samples of a range of an image of 5 x 18 pixels.
image::Film matteFilm(render::SampleRange samples) {
  image::Film film(5, 18, matteLayers());
  for (std::uint32_t pixel = 0; pixel < 90; ++pixel) {
    for (std::uint32_t i = samples.first; i < samples.end; ++i) {
      const std::uint32_t x = pixel % 5, y = pixel / 5;
      film.addSample(x, y, glm::dvec3(1), i);
      const auto name = nameAt(x, y, i);
      image::addIds(film.idsAt(MatteKind::object, x, y), {name ? image::matteId(*name) : image::kNoId, 1});
      image::addIds(film.idsAt(MatteKind::material, x, y), {image::matteId("only"), 1});
    }
  }
  return film;
}

FilmHeader matteHeader(const image::Film& film, render::SampleRange samples) {
  FilmHeader header = madeHeader({5, 18}, 8);
  header.layers = matteLayers();
  header.matteNames = {kNames, {"only"}};
  setCoverage(header, film, samples.first);
  return header;
}

std::filesystem::path writeMattes(const std::filesystem::path& file, render::SampleRange samples) {
  const image::Film film = matteFilm(samples);
  writeFilm(file, matteHeader(film, samples), film);
  return file;
}

}  // namespace

TEST_CASE("a film with mattes has version 5 and preserves counts and names") {
  const TemporaryFolder folder;
  FilmReader reader(writeMattes(folder / "a.exr", {0, 8}));
  CHECK(reader.header().format() == 5);
  CHECK(reader.header().matteNames == image::MatteNames{kNames, {"only"}});
  CHECK(reader.header().matteSlots == std::array<std::uint32_t, 2>{5, 1});
  const image::Film film = matteFilm({0, 8}), back = readFilm(reader);
  CHECK(back.ids(MatteKind::object) == film.ids(MatteKind::object));
  CHECK(back.ids(MatteKind::material) == film.ids(MatteKind::material));
}

TEST_CASE("merged mattes have the bytes of those of all samples") {
  const TemporaryFolder folder;
  const std::vector<std::filesystem::path> parts{writeMattes(folder / "b.exr", {3, 8}),
                                                 writeMattes(folder / "a.exr", {0, 3})};
  const MergedFilm merged = mergeFilms(parts, {});
  writeFilm(folder / "merged.exr", merged.header, merged.film);
  CHECK(bytesOf(folder / "merged.exr") == bytesOf(writeMattes(folder / "whole.exr", {0, 8})));
}

TEST_CASE("mattes that do not match the samples are refused") {
  const TemporaryFolder folder;
  image::Film film = matteFilm({0, 8});
  FilmHeader header = matteHeader(film, {0, 8});
  image::IdCounts& counts = film.ids(MatteKind::object)[7];
  SECTION("a sample too many") { ++counts.back().count; }
  SECTION("a sample too few") { counts.pop_back(); }
  SECTION("not by rising ids") { std::swap(counts[0], counts[1]); }
  SECTION("an id without a name") { counts.back().id = 0xffffffffu; }
  SECTION("a count of zero in between") { counts[0] = {0, 0}; }
  SECTION("a missing name") { header.matteNames[0].pop_back(); }
  writeFilm(folder / "a.exr", header, film);
  CHECK_THAT(refusalOf(folder / "a.exr"), Catch::Contains("the mattes of a pixel do not match its samples"));
}

TEST_CASE("descriptions of mattes that no film has are refused") {
  const image::Film film = matteFilm({0, 8});
  const std::string text = toJson(matteHeader(film, {0, 8}));
  CHECK(headerFromJson(text) == matteHeader(film, {0, 8}));
  const auto refused = [&](const std::string& before, const std::string& after) {
    std::string changed = text;
    REQUIRE(changed.find(before) != std::string::npos);
    changed.replace(changed.find(before), before.size(), after);
    CHECK_THROWS_AS(headerFromJson(changed), FileError);
  };
  refused("\"ball\",\"box\"", "\"box\",\"ball\"");
  refused("\"ball\",\"box\"", "\"box\",\"box\"");
  refused("\"ball\"", "3");
  refused("\"slots\":0", "\"slots\":70000");
  refused("\"slots\":0", "\"slots\":-1");
  refused("\"object\"", "\"objects\"");
  refused("\"mattes\"", "\"matte\"");
  refused("\"format\":5", "\"format\":3");
}
