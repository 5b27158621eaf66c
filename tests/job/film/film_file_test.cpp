// Film files: a written film is read again, equal films have equal bytes, and other programs see a picture.
#include "host/job/film/film_file.h"

#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <catch2/catch.hpp>

#include "host/base/errors.h"
#include "host/image/image.h"
#include "tests/base/temporary_folder.h"
#include "tests/job/film/made_films.h"

using namespace candela;
using namespace candela::film;

namespace {

bool equal(const image::Film& a, const image::Film& b) {
  return a.width() == b.width() && a.height() == b.height() && a.hash() == b.hash();
}

}  // namespace

TEST_CASE("a film file preserves header and film, bit for bit") {
  const TemporaryFolder folder;
  const auto file = writeBox(folder / "a.exr", madeHeader({64, 60}, 16), kBox);
  FilmReader reader(file);
  CHECK(reader.header().window == kBox.window);
  CHECK(reader.header().covered == std::vector{kBox});
  CHECK(reader.header().begun.empty());
  CHECK_FALSE(reader.header().isComplete());
  CHECK(equal(readFilm(reader), madeFilm(kBox)));
}

TEST_CASE("equal films have equal bytes, and different films have different checks") {
  const TemporaryFolder folder;
  const FilmHeader header = madeHeader({64, 60}, 16);
  const auto a = writeBox(folder / "a.exr", header, kBox);
  const auto b = writeBox(folder / "b.exr", header, kBox);
  CHECK(bytesOf(a) == bytesOf(b));
  FilmHeader other = header;
  other.tracers[0].driver = "another driver";
  const auto c = writeBox(folder / "c.exr", other, kBox);
  CHECK(FilmReader(a).check() == FilmReader(b).check());
  CHECK(FilmReader(a).check() != FilmReader(c).check());
}

TEST_CASE("a film file is a picture with variance at its place in the image") {
  const TemporaryFolder folder;
  const auto file = writeBox(folder / "a.exr", madeHeader({64, 60}, 16), kBox);
  const image::Image expected = image::toImage(madeFilm(kBox));
  const image::Image image = image::readImage(file);
  CHECK(image.width == kBox.window.width);
  CHECK(image.rgb == expected.rgb);
  CHECK(image.luminanceVariance == expected.luminanceVariance);
  CHECK(image.sampleCounts == expected.sampleCounts);
  CHECK(image.badSampleCounts == expected.badSampleCounts);
  CHECK(image.metadata.at("candela.seed") == "7");
  const Imf::InputFile exr(file.c_str());
  CHECK(exr.header().dataWindow() == Imath::Box2i({3, 5}, {39, 54}));
  CHECK(exr.header().displayWindow() == Imath::Box2i({0, 0}, {63, 59}));
}

TEST_CASE("a film without samples, of one pixel, or of the largest side is a film") {
  const TemporaryFolder folder;
  for (const render::Extent& size : {render::Extent{1, 1}, {65535, 1}, {1, 65535}, {17, 16}}) {
    FilmHeader header = madeHeader(size, 4);
    const image::Film empty(size.width, size.height);
    writeFilm(folder / "a.exr", header, empty);
    FilmReader reader(folder / "a.exr");
    CHECK(reader.header() == header);
    CHECK(equal(readFilm(reader), empty));
  }
}

TEST_CASE("sums of 96 bits and counts of 32 bits survive") {
  const TemporaryFolder folder;
  FilmHeader header = madeHeader({1, 1}, 1u << 30);
  header.covered = {{{0, 0, 1, 1}, {0, 1u << 30}}};
  image::Film film(1, 1);
  film.at(0, 0) = {{1, 2, 0xffffffffu}, 1u << 30, {0xfffffffeu, 4, 5}, 6, {7, 0x80000000u, 9}, 10, {11, 12, 13}, 0};
  writeFilm(folder / "a.exr", header, film);
  FilmReader reader(folder / "a.exr");
  CHECK(equal(readFilm(reader), film));
}

TEST_CASE("a film with alpha preserves its hit counts, and is a picture with alpha") {
  const TemporaryFolder folder;
  FilmHeader header = madeHeader({2, 1}, 8);
  header.settings["background"] = "none";
  image::Film film(2, 1);
  for (std::uint32_t i = 0; i < 8; ++i) {
    film.addSample(0, 0, glm::dvec3(0.5), i);
    film.addSample(1, 0, glm::dvec3(0.5), i);
    if (i < 2) film.addHit(1, 0);
  }
  setCoverage(header, film, 0);
  writeFilm(folder / "a.exr", header, film);
  FilmReader reader(folder / "a.exr");
  const image::Film back = readFilm(reader);
  CHECK(equal(back, film));
  CHECK(back.at(0, 0).hitCount == 0);
  CHECK(back.at(1, 0).hitCount == 2);
  CHECK(image::readImage(folder / "a.exr").alpha == std::vector<float>{0, 0.25f});

  header.settings.erase("background");
  writeFilm(folder / "opaque.exr", header, film);  // without the channels of alpha
  FilmReader opaque(folder / "opaque.exr");
  CHECK(readFilm(opaque).at(1, 0).hitCount == 0);
  CHECK(image::readImage(folder / "opaque.exr").alpha.empty());
  CHECK(bytesOf(folder / "opaque.exr").find("hits") == std::string::npos);

  header.settings["background"] = "none";
  film.at(0, 0).hitCount = 9;
  writeFilm(folder / "b.exr", header, film);
  CHECK_THAT(refusalOf(folder / "b.exr"), Catch::Contains("pixel (0, 0) holds more hits than samples"));
}

TEST_CASE("a film with layers preserves their sums, bit for bit, and layers that every film has need no sums") {
  const TemporaryFolder folder;
  image::LayerSet layers;
  for (const auto layer : {image::Layer::position, image::Layer::emission, image::Layer::samples}) layers.add(layer);
  image::Film film(3, 20, layers);
  for (std::uint32_t i = 0; i < film.width() * film.height(); ++i) {
    film.addSample(i % 3, i / 3, glm::dvec3(i), 0);
    image::LayerSample sample;
    if (i % 4 != 0) sample.hit = image::LayerSample::FirstHit{.position = {-1.0 / (i + 1), i, 1e9}};
    film.addLayers(i % 3, i / 3, sample, glm::dvec3(i));
  }
  FilmHeader header = madeHeader({3, 20}, 1);
  header.layers = withSums(layers);
  setCoverage(header, film, 0);
  writeFilm(folder / "a.exr", header, film);
  FilmReader reader(folder / "a.exr");
  const image::Film back = readFilm(reader);
  CHECK(equal(back, film));
  CHECK(back.layers() == header.layers);
  CHECK(back.layerRows() == film.layerRows());
  const std::string bytes = bytesOf(folder / "a.exr");
  for (const char* name : {"layerHits", "badLayerSamples", "sum.position.X.0", "sum.unscattered.B.2"}) {
    CHECK(bytes.find(name) != std::string::npos);
  }
  CHECK(bytes.find("scatteredOnce") == std::string::npos);

  film.layerRowsAt(2, 19)[0].words[0] = 2;
  writeFilm(folder / "b.exr", header, film);
  CHECK_THAT(refusalOf(folder / "b.exr"), Catch::Contains("pixel (2, 19) has layers of more samples than it holds"));
}

TEST_CASE("files that are not films are refused, and the message says what they are") {
  const TemporaryFolder folder;
  image::writeImage(folder / "picture.exr", image::toImage(madeFilm(kBox)), {});
  CHECK_THAT(refusalOf(folder / "picture.exr"),
             Catch::Contains("picture.exr: ") && Catch::Contains("without the sums"));
  writeBytes(folder / "text", "the quick brown fox");
  CHECK_THAT(refusalOf(folder / "text"), Catch::Contains("not an OpenEXR file"));
  writeBytes(folder / "empty", "");
  CHECK_THAT(refusalOf(folder / "empty"), Catch::Contains("not an OpenEXR file"));
  CHECK_THAT(refusalOf(folder / "nothing"), Catch::Contains("nothing: No such file"));
  CHECK_THAT(refusalOf(folder.path()), Catch::Contains("not a regular file"));
  CHECK_THAT(refusalOf("/dev/zero"), Catch::Contains("not a regular file"));
}

TEST_CASE("a film that cannot be written leaves the old file") {
  const TemporaryFolder folder;
  CHECK_THROWS_AS(writeBox(folder / "no/such/folder.exr", madeHeader({64, 60}, 16), kBox), FileError);
  CHECK_THROWS_AS(writeBox("/dev/full", madeHeader({64, 60}, 16), kBox), FileError);
}
