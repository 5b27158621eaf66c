// Mattes: hashes of names by published values, counts of ids, and their ranks in files.
#include "host/image/mattes.h"

#include <bit>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "host/image/cryptomatte.h"
#include "host/image/image.h"
#include "host/image/murmur_hash.h"

using namespace candela::image;

namespace {

float numberOf(std::uint32_t id) { return std::bit_cast<float>(id); }

Film filmWith(const IdCounts& counts) {
  LayerSet layers;
  layers.add(Layer::cryptoObject);
  Film film(1, 1, layers);
  film.ids(MatteKind::object)[0] = counts;
  return film;
}

}  // namespace

TEST_CASE("MurmurHash3 has its published values") {
  CHECK(murmurHash3("") == 0);
  CHECK(murmurHash3("", 1) == 0x514e28b7u);
  CHECK(murmurHash3("", 0xffffffffu) == 0x81f16f39u);
  CHECK(murmurHash3("hello") == 0x248bfa47u);
  CHECK(murmurHash3("hello, world") == 0x149bbb7fu);
  CHECK(murmurHash3("The quick brown fox jumps over the lazy dog") == 0x2e4ff723u);
  CHECK(murmurHash3("a", 0x9747b28cu) == 0x7fa09ea6u);
  CHECK(murmurHash3("ab", 0x9747b28cu) == 0x74875592u);
  CHECK(murmurHash3("abc", 0x9747b28cu) == 0xc84a62ddu);
  CHECK(murmurHash3("abcd", 0x9747b28cu) == 0xf0478627u);
  CHECK(murmurHash3("\xcf\x80\xcf\x80\xcf\x80\xcf\x80\xcf\x80\xcf\x80\xcf\x80\xcf\x80", 0x9747b28cu) == 0xd58063c1u);
}

TEST_CASE("names have the ids of Cryptomatte's specification, and every id is a normal number") {
  CHECK(matteId("bunny") == 0x13851a76u);
  CHECK(matteId("default") == 0x42c9679fu);
  std::uint32_t changed = 0;
  for (std::uint32_t i = 0; i < 10000; ++i) {
    const std::string name = "object" + std::to_string(i);
    CHECK(std::isnormal(numberOf(matteId(name))));
    changed += matteId(name) != murmurHash3(name) ? 1 : 0;
    CHECK(((matteId(name) ^ murmurHash3(name)) | 1u << 23) == 1u << 23);
  }
  CHECK(changed > 20);  // 2 of 256 exponents
  CHECK(changed < 160);
}

TEST_CASE("counts of ids are sorted, and do not depend on the order of samples") {
  IdCounts a, b;
  for (const std::uint32_t id : {7u, 0u, 9u, 7u, 3u}) addIds(a, {id, 1});
  for (const std::uint32_t id : {3u, 7u, 7u, 9u, 0u}) addIds(b, {id, 1});
  CHECK(a == IdCounts{{0, 1}, {3, 1}, {7, 2}, {9, 1}});
  CHECK(a == b);
  addIds(a, {8, 0});
  CHECK(a == b);
  addIds(a, IdCounts{{1, 4}, {9, 2}});
  CHECK(a == IdCounts{{0, 1}, {1, 4}, {3, 1}, {7, 2}, {9, 3}});
  CHECK(sampleCountOf(a) == 11);
}

TEST_CASE("films with mattes add their counts, and clear() removes them") {
  Film film = filmWith({{5, 2}});
  film.merge(filmWith({{4, 1}, {5, 3}}));
  CHECK(film.ids(MatteKind::object)[0] == IdCounts{{4, 1}, {5, 5}});
  CHECK(film.ids(MatteKind::material).empty());
  film.clear();
  CHECK(film.ids(MatteKind::object)[0].empty());
}

TEST_CASE("ranks fall by coverage, equal ones rise by id, and samples without a hit have none") {
  const IdCounts counts{{kNoId, 4}, {11, 2}, {12, 5}, {13, 2}, {14, 1}, {15, 1}, {16, 1}};
  const std::pair<std::uint32_t, float> ranks[]{{12, 5}, {11, 2}, {13, 2}, {14, 1}, {15, 1}, {16, 1}};
  for (std::size_t rank = 0; rank < kMatteRanks; ++rank) {
    CHECK(std::bit_cast<std::uint32_t>(cryptomatteValues(counts)[2 * rank]) == ranks[rank].first);
    CHECK(cryptomatteValues(counts)[2 * rank + 1] == ranks[rank].second / 16);
  }
  CHECK(cryptomatteValues({{kNoId, 3}})[0] == 0);
  CHECK(cryptomatteValues({})[1] == 0);
}

TEST_CASE("more ids than ranks are in the film and not in the image") {
  IdCounts counts;
  for (std::uint32_t id = 1; id <= 40; ++id) addIds(counts, {id, id});
  const Film film = filmWith(counts);
  Image image = toImage(film);
  addLayers(image, film);
  REQUIRE(image.channels.size() == 2 * kMatteRanks);
  CHECK(image.channels[0].name == "CryptoObject00.r");
  CHECK(image.channels[5].name == "CryptoObject01.g");
  CHECK(image.channels[11].name == "CryptoObject02.a");
  CHECK(std::bit_cast<std::uint32_t>(image.channels[10].values[0]) == 35);
  CHECK(image.channels[11].values[0] == 35.0f / 820);
}

TEST_CASE("the metadata name the layer, the hash and the names") {
  const auto metadata = cryptomatteMetadata(MatteKind::material, std::vector<std::string>{"bunny", "\"d\""});
  REQUIRE(metadata.size() == 4);
  const std::string key = metadata.begin()->first.substr(0, 20);
  CHECK(key == "cryptomatte/be359d6/");
  CHECK(metadata.at(key + "name") == "CryptoMaterial");
  CHECK(metadata.at(key + "hash") == "MurmurHash3_32");
  CHECK(metadata.at(key + "conversion") == "uint32_to_float32");
  const auto manifest = nlohmann::json::parse(metadata.at(key + "manifest"));
  CHECK(manifest.size() == 2);
  CHECK(manifest.at("bunny") == "13851a76");
}
