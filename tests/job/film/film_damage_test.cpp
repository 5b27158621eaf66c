// Damaged film files are refused with a reason, and forged ones do no harm.
#include <zlib.h>

#include <array>
#include <catch2/catch.hpp>
#include <cstring>
#include <random>

#include "host/job/film/film_channels.h"
#include "host/job/film/film_head.h"
#include "host/job/film/film_stream.h"
#include "tests/base/temporary_folder.h"
#include "tests/job/film/made_films.h"

using namespace candela;
using namespace candela::film;

namespace {

std::span<const std::byte> viewOf(const std::string& bytes) { return std::as_bytes(std::span(bytes)); }

std::size_t headEnd(const std::string& bytes) {
  const FilmHead head = parseHead(viewOf(bytes));
  return head.headerBytes + head.blockChecks.size();  // 8 digits and 8 bytes of the table for each block
}

void flipBit(std::string& bytes, std::mt19937& random) {
  char& byte = bytes[random() % bytes.size()];
  byte = static_cast<char>(byte ^ (1 << (random() % 8)));
}

void overwrite(std::string& bytes, std::mt19937& random) {
  const std::size_t at = random() % bytes.size();
  for (std::size_t i = at; i < std::min(bytes.size(), at + 1 + random() % 64); ++i)
    bytes[i] = static_cast<char>(random());
}

// Two blocks change places. All are 4 KiB or so; the smaller size of two is exchanged.
void swapBlocks(std::string& bytes, std::mt19937& random) {
  const std::size_t start = headEnd(bytes);
  const std::size_t length = 64 + random() % 512;
  const std::size_t a = start + random() % ((bytes.size() - start) / 2 - length);
  const std::size_t b = start + (bytes.size() - start) / 2 + random() % ((bytes.size() - start) / 2 - length);
  std::swap_ranges(bytes.begin() + static_cast<std::ptrdiff_t>(a),
                   bytes.begin() + static_cast<std::ptrdiff_t>(a + length),
                   bytes.begin() + static_cast<std::ptrdiff_t>(b));
}

// The data window, the display window or the size in the description.
void enlarge(std::string& bytes, std::mt19937& random) {
  const char* const names[]{"dataWindow", "displayWindow"};
  const std::size_t at = bytes.find(names[random() % 2]);
  const std::size_t value = bytes.find("box2i", at) + 6 + 4 + 4 * (random() % 4);
  const std::int32_t huge = static_cast<std::int32_t>(random());
  std::memcpy(bytes.data() + value, &huge, sizeof huge);
}

std::string damaged(std::string bytes, std::mt19937& random) {
  switch (random() % 6) {
    case 0:
    case 1:
      flipBit(bytes, random);
      break;
    case 2:
      overwrite(bytes, random);
      break;
    case 3:
      bytes.resize(random() % bytes.size());
      break;
    case 4:
      swapBlocks(bytes, random);
      break;
    default:
      enlarge(bytes, random);
  }
  return bytes;
}

void requireRefused(int count, std::uint32_t seed) {
  const TemporaryFolder folder;
  const std::string good = bytesOf(writeBox(folder / "good.exr", madeHeader({64, 60}, 16), kBox));
  std::mt19937 random(seed);
  for (int i = 0; i < count; ++i) {
    const std::string bytes = damaged(good, random);
    if (bytes == good) continue;  // the overwritten bytes were equal
    writeBytes(folder / "bad.exr", bytes);
    INFO("corruption " << i << " of seed " << seed);
    CHECK_THAT(refusalOf(folder / "bad.exr"), Catch::StartsWith((folder / "bad.exr").string() + ": "));
  }
}

// Sets the checksum of the header, as a forger would.
void seal(std::string& bytes) {
  FilmHead head;
  std::size_t end = 0;
  try {
    head = parseHead(viewOf(bytes));
    end = std::min(bytes.size(), head.headerBytes + head.blockChecks.size());
  } catch (const std::exception&) {
    return;
  }
  bytes.replace(head.checkOffset, kCheckDigits, kCheckDigits, '0');
  bytes.replace(head.checkOffset, kCheckDigits, crcText(crc32Of(0, viewOf(bytes).first(end))));
}

// Changes a byte after the header, and the checksums with it.
void forgeBlock(std::string& bytes, std::mt19937& random) {
  const std::size_t start = headEnd(bytes);
  const FilmHead head = parseHead(viewOf(bytes));
  bytes[start + random() % (bytes.size() - start)] = static_cast<char>(random());
  std::string checks;
  for (std::size_t at = start; at + kBlockHeadBytes <= bytes.size();) {
    std::uint32_t size = 0;
    std::memcpy(&size, bytes.data() + at + 4, sizeof size);
    const std::size_t end = std::min(bytes.size(), at + kBlockHeadBytes + size);
    checks += crcText(crc32Of(0, viewOf(bytes).subspan(at, end - at)));
    at = end;
  }
  checks.resize(head.blockChecks.size(), '0');
  bytes.replace(bytes.find(head.blockChecks), checks.size(), checks);
}

void readForged(int count, std::uint32_t seed) {
  const TemporaryFolder folder;
  const std::string good = bytesOf(writeBox(folder / "good.exr", madeHeader({64, 60}, 16), kBox));
  std::mt19937 random(seed);
  int refused = 0;
  for (int i = 0; i < count; ++i) {
    std::string bytes = good;
    if (random() % 2 == 0) {
      forgeBlock(bytes, random);
    } else {
      const std::size_t at = 8 + random() % (headEnd(bytes) - 8);
      bytes[at] = static_cast<char>(random());
    }
    seal(bytes);
    writeBytes(folder / "forged.exr", bytes);
    refused += refusalOf(folder / "forged.exr").empty() ? 0 : 1;
  }
  CHECK(refused > count / 4);  // many changes contradict the rest of the file; the others are films
}

}  // namespace

TEST_CASE("every bit of a film file is covered by a checksum: all flips in and around its header are refused") {
  const TemporaryFolder folder;
  const std::string good = bytesOf(writeBox(folder / "good.exr", madeHeader({8, 40}, 16), {{2, 3, 4, 33}, {0, 2}}));
  for (std::size_t at = 0; at < good.size(); at += at < headEnd(good) ? 7 : 31) {
    std::string bytes = good;
    bytes[at] = static_cast<char>(bytes[at] ^ (1 << (at % 8)));
    writeBytes(folder / "bad.exr", bytes);
    INFO("byte " << at);
    CHECK_FALSE(refusalOf(folder / "bad.exr").empty());
  }
}

TEST_CASE("random damage to film files is refused with a reason") { requireRefused(100, 1); }

TEST_CASE("a thousand random corruptions of film files are refused with a reason", "[slow]") {
  requireRefused(1000, 2);
}

TEST_CASE("film files with forged checksums are read or refused") { readForged(200, 3); }

TEST_CASE("ten thousand film files with forged checksums are read or refused", "[slow]") { readForged(10000, 4); }

TEST_CASE("a film file that is truncated or has trailing data is refused, wherever it ends") {
  const TemporaryFolder folder;
  const std::string good = bytesOf(writeBox(folder / "good.exr", madeHeader({64, 60}, 16), kBox));
  for (std::size_t length = 0; length < good.size(); length += 1 + length / 16) {
    writeBytes(folder / "bad.exr", good.substr(0, length));
    INFO(length << " bytes");
    CHECK_FALSE(refusalOf(folder / "bad.exr").empty());
  }
  writeBytes(folder / "bad.exr", good + '\0');
  CHECK_THAT(refusalOf(folder / "bad.exr"), Catch::Contains("data follows its last block"));
}

TEST_CASE("damaged rows are named") {
  const TemporaryFolder folder;
  std::string bytes = bytesOf(writeBox(folder / "good.exr", madeHeader({64, 60}, 16), kBox));
  bytes.back() = static_cast<char>(bytes.back() ^ 1);
  writeBytes(folder / "bad.exr", bytes);
  CHECK_THAT(refusalOf(folder / "bad.exr"), Catch::Contains("rows 53 to 54 do not match their checksum"));
}

TEST_CASE("a forged film of huge dimensions is refused before memory is allocated") {
  const TemporaryFolder folder;
  std::string bytes = bytesOf(writeBox(folder / "good.exr", madeHeader({4, 4}, 16), {{0, 0, 4, 4}, {0, 2}}));
  const auto replaceAll = [&](const std::string& from, const std::string& to) {
    REQUIRE(from.size() == to.size());
    for (std::size_t at = bytes.find(from); at != std::string::npos; at = bytes.find(from, at + 1)) {
      bytes.replace(at, from.size(), to);
    }
  };
  // 9 pixels instead of 4 each way would fit the number of blocks, so that only the film's coverage shows the error.
  replaceAll("\"size\":[4,4]", "\"size\":[9,9]");
  seal(bytes);
  writeBytes(folder / "forged.exr", bytes);
  CHECK_THAT(refusalOf(folder / "forged.exr"), Catch::Contains("windows"));
}

TEST_CASE("a film whose pixels contradict its description is refused") {
  const TemporaryFolder folder;
  FilmHeader header = madeHeader({8, 8}, 16);
  header.covered = {{{0, 0, 8, 8}, {0, 4}}};
  image::Film film = madeFilm({{0, 0, 8, 8}, {0, 4}});
  film.at(2, 3).sampleCount = 5;
  writeFilm(folder / "a.exr", header, film);
  CHECK_THAT(refusalOf(folder / "a.exr"), Catch::Contains("pixel (2, 3) holds 5 samples, and the file says 4 to 4"));
  header.begun = {{{2, 3, 1, 1}, {4, 5}}};
  writeFilm(folder / "a.exr", header, film);
  CHECK(refusalOf(folder / "a.exr").empty());
}

TEST_CASE("a forged film of nested boxes is refused, and not divided into millions") {
  const TemporaryFolder folder;
  FilmHeader header = madeHeader({4096, 4096}, 4096);
  header.window = {2047, 2047, 2, 2};
  for (std::uint32_t i = 0; i < 2048; ++i) {
    header.covered.push_back({{i, i, 4096 - 2 * i, 4096 - 2 * i}, {2 * i, 2 * i + 1}});
  }
  writeFilm(folder / "a.exr", header, image::Film(2, 2));
  CHECK_THAT(refusalOf(folder / "a.exr"),
             Catch::Contains("the description of the film: /covered: a box exceeds the window"));
  header.window = {0, 0, 4096, 4096};
  CHECK_THROWS_WITH(headerFromJson(toJson(header)),
                    "the description of the film: /covered: the boxes overlap, or are not in the form that is written");
}
