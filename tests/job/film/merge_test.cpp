// Merging: the bytes of one film for any division and any order, and refusals that name the error.
#include "host/job/film/merge.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "host/base/errors.h"
#include "tests/base/temporary_folder.h"
#include "tests/job/film/made_films.h"

using namespace candela;
using namespace candela::film;
using Files = std::vector<std::filesystem::path>;

namespace {

constexpr std::uint32_t kWidth = 41, kHeight = 37, kSamples = 12;
const SampleBox kWhole{{0, 0, kWidth, kHeight}, {0, kSamples}};

FilmHeader header() { return madeHeader({kWidth, kHeight}, kSamples); }

// A film of each box of a division by samples and crops.
Files writeParts(const TemporaryFolder& folder, std::uint32_t columns, std::uint32_t rows, std::uint32_t ranges) {
  Files files;
  for (std::uint32_t i = 0; i < columns * rows * ranges; ++i) {
    const auto cut = [](std::uint32_t length, std::uint32_t parts, std::uint32_t index) {
      return std::pair{length * index / parts, length * (index + 1) / parts};
    };
    const auto [x, right] = cut(kWidth, columns, i % columns);
    const auto [y, bottom] = cut(kHeight, rows, i / columns % rows);
    const auto [first, end] = cut(kSamples, ranges, i / columns / rows);
    const SampleBox box{{x, y, right - x, bottom - y}, {first, end}};
    files.push_back(writeBox(folder / ("part" + std::to_string(i) + ".exr"), header(), box));
  }
  return files;
}

std::filesystem::path mergeTo(const std::filesystem::path& file, const Files& files, const MergeOptions& options = {}) {
  const MergedFilm merged = mergeFilms(files, options);
  writeFilm(file, merged.header, merged.film);
  return file;
}

std::string refusalOfMerge(const Files& files, const MergeOptions& options = {}) {
  try {
    mergeFilms(files, options);
  } catch (const FileError& error) {
    return error.what();
  }
  return {};
}

}  // namespace

TEST_CASE("merged films have the bytes of one film, for every division and order") {
  const TemporaryFolder folder;
  const std::string whole = bytesOf(writeBox(folder / "whole.exr", header(), kWhole));
  struct Division {
    std::uint32_t columns, rows, ranges;
  };
  std::mt19937 random(1);
  for (const auto& [columns, rows, ranges] :
       {Division{1, 1, 1}, {1, 1, 5}, {4, 1, 1}, {1, 5, 1}, {3, 2, 1}, {2, 2, 3}, {1, 1, kSamples}}) {
    INFO(columns << " columns, " << rows << " rows, " << ranges << " ranges");
    Files files = writeParts(folder, columns, rows, ranges);
    for (int order = 0; order < 4; ++order) {
      CHECK(bytesOf(mergeTo(folder / "merged.exr", files)) == whole);
      std::ranges::shuffle(files, random);
    }
  }
}

TEST_CASE("films may be merged as a tree, and every way of pairing them gives the same bytes") {
  const TemporaryFolder folder;
  const std::string whole = bytesOf(writeBox(folder / "whole.exr", header(), kWhole));
  std::mt19937 random(2);
  for (int run = 0; run < 5; ++run) {
    Files files = writeParts(folder, 3, 2, 2);
    for (int i = 0; files.size() > 1; ++i) {
      std::ranges::shuffle(files, random);
      const std::filesystem::path target = folder / ("node" + std::to_string(run * 100 + i) + ".exr");
      const MergeOptions options{.mixedDevices = false, .partial = files.size() > 2};
      mergeTo(target, {files[0], files[1]}, options);
      files.erase(files.begin(), files.begin() + 2);
      files.push_back(target);
    }
    CHECK(bytesOf(files[0]) == whole);
  }
}

TEST_CASE("partial merges of equal parts are equal, too, and name what is missing") {
  const TemporaryFolder folder;
  Files files = writeParts(folder, 2, 1, 3);
  files.erase(files.begin() + 3);
  CHECK(refusalOfMerge(files) == "samples 4:8 of crop 20,0,21,37 are missing; partial merges what there is");
  const MergedFilm merged = mergeFilms(files, {.mixedDevices = false, .partial = true});
  CHECK(merged.missing == std::vector{SampleBox{{20, 0, 21, 37}, {4, 8}}});
  const std::string bytes = bytesOf(mergeTo(folder / "a.exr", files, {.mixedDevices = false, .partial = true}));
  std::ranges::reverse(files);
  CHECK(bytesOf(mergeTo(folder / "b.exr", files, {.mixedDevices = false, .partial = true})) == bytes);
  FilmReader reader(folder / "a.exr");
  CHECK_NOTHROW(readFilm(reader));
  CHECK_FALSE(firstSampleOf(reader.header()));
}

TEST_CASE("many gaps are named by the first and the number of the others") {
  const TemporaryFolder folder;
  const Files files = writeParts(folder, 1, 1, kSamples);
  Files even;
  for (std::size_t i = 0; i < files.size(); i += 2) even.push_back(files[i]);
  CHECK_THAT(refusalOfMerge({even[0], even[1]}), Catch::Contains("samples 1:2 of crop 0,0,41,37, samples 3:12"));
  CHECK_THAT(refusalOfMerge(even), Catch::Contains("and 1 more are missing"));
}

TEST_CASE("films that overlap, or a film given twice, are refused by name") {
  const TemporaryFolder folder;
  const Files files = writeParts(folder, 1, 1, 2);
  const auto third = writeBox(folder / "third.exr", header(), {{30, 30, 4, 4}, {5, 7}});
  CHECK_THAT(refusalOfMerge({files[0], files[1], third}),
             Catch::Contains("part0.exr has samples 0:6 of crop 0,0,41,37") &&
                 Catch::Contains("third.exr has samples 5:7") && Catch::Contains("overlap"));
  CHECK_THAT(refusalOfMerge({files[0], files[0]}), Catch::Contains("overlap"));
}

TEST_CASE("films of another scene, setting, kernel or program are refused, and the difference is named") {
  const TemporaryFolder folder;
  const auto first = writeBox(folder / "a.exr", header(), {kWhole.window, {0, 6}});
  const auto refusalWith = [&](const std::function<void(FilmHeader&)>& change, const MergeOptions& options = {}) {
    FilmHeader changed = header();
    change(changed);
    return refusalOfMerge({first, writeBox(folder / "b.exr", changed, {kWhole.window, {6, kSamples}})}, options);
  };
  CHECK_THAT(refusalWith([](FilmHeader& h) { h.sceneHash = "ffffffffffffffff"; }), Catch::Contains("scene's hash"));
  CHECK_THAT(refusalWith([](FilmHeader& h) { h.seed = 8; }),
             Catch::Contains("seed is 7 in") && Catch::Contains("b.exr"));
  CHECK_THAT(refusalWith([](FilmHeader& h) { h.samplesPerPixel = 24; }), Catch::Contains("spp is 12 in"));
  CHECK_THAT(refusalWith([](FilmHeader& h) { h.size.width = 50; }), Catch::Contains("size is 41x37 in"));
  CHECK_THAT(refusalWith([](FilmHeader& h) { h.settings["sampler"] = "independent"; }), Catch::Contains("sampler is"));
  const MergeOptions mixed{.mixedDevices = true, .partial = false};
  CHECK_THAT(refusalWith([](FilmHeader& h) { h.tracers[0].kernels = "x"; }, mixed),
             Catch::Contains("hash of the kernels"));
  CHECK_THAT(refusalWith([](FilmHeader& h) { h.tracers[0].program = "2.0"; }, mixed),
             Catch::Contains("program's version"));
  const auto otherDevice = [](FilmHeader& h) { h.tracers[0].device = "another device"; };
  CHECK_THAT(refusalWith(otherDevice),
             Catch::Contains("the device is a device in") && Catch::Contains("mixed-devices merges"));
  CHECK(refusalWith(otherDevice, mixed).empty());
  CHECK(refusalWith([](FilmHeader& h) { h.tracers[0] = {"cpu", "", "GCC", "reference", "1.0"}; }, mixed).empty());
}

TEST_CASE("films that the first rule of stopping sampled can be read, but not merged") {
  const TemporaryFolder folder;
  FilmHeader adaptive = madeHeader({64, 64}, 32);
  adaptive.settings["noise-threshold"] = "0.4";
  adaptive.covered = {{{0, 0, 64, 64}, {0, 32}}};
  const image::Film film = madeFilm({{0, 0, 64, 64}, {0, 16}});
  const auto file = folder / "a.exr";
  writeFilm(file, adaptive, film);
  FilmReader reader(file);
  CHECK(reader.header().isComplete());
  CHECK(readFilm(reader).hash() == film.hash());
  CHECK_THAT(refusalOfMerge({file}), Catch::Contains("a.exr was sampled with a noise threshold by an earlier rule"));
  adaptive.settings["stopping-rule"] = "2";
  writeFilm(file, adaptive, film);
  CHECK(refusalOfMerge({file}).empty());
}

TEST_CASE("a film of several devices names them all, in whatever order it was merged") {
  const TemporaryFolder folder;
  Files files;
  for (std::uint32_t i = 0; i < 3; ++i) {
    FilmHeader own = header();
    own.tracers[0].device = i == 1 ? "b" : "a";
    files.push_back(writeBox(folder / (std::to_string(i) + ".exr"), own, {kWhole.window, {4 * i, 4 * i + 4}}));
  }
  const MergeOptions mixed{.mixedDevices = true, .partial = false};
  const std::string bytes = bytesOf(mergeTo(folder / "a.exr", files, mixed));
  std::ranges::reverse(files);
  CHECK(bytesOf(mergeTo(folder / "b.exr", files, mixed)) == bytes);
  const FilmHeader merged = FilmReader(folder / "a.exr").header();
  REQUIRE(merged.tracers.size() == 2);
  CHECK(merged.tracers[1].device == "b");
  CHECK(merged.isMixed());
}

TEST_CASE("films of different kernels are refused in whatever order a film of the reference comes with them") {
  const TemporaryFolder folder;
  Files files;
  for (std::uint32_t i = 0; i < 3; ++i) {
    FilmHeader own = header();
    own.tracers[0].kernels = i == 0 ? "reference" : i == 1 ? "x" : "y";
    files.push_back(writeBox(folder / (std::to_string(i) + ".exr"), own, {kWhole.window, {4 * i, 4 * i + 4}}));
  }
  const MergeOptions mixed{.mixedDevices = true, .partial = false};
  do CHECK_THAT(refusalOfMerge(files, mixed), Catch::Contains("hash of the kernels"));
  while (std::next_permutation(files.begin(), files.end()));
}

TEST_CASE("an interrupted film is resumed before it is merged, unless a partial merge is requested") {
  const TemporaryFolder folder;
  const auto second = writeBox(folder / "b.exr", header(), {kWhole.window, {6, kSamples}});
  FilmHeader interrupted = header();
  image::Film film = madeFilm({kWhole.window, {0, 4}});
  film.addSample(0, 0, madeRadiance(0, 0, 4), 4);
  setCoverage(interrupted, film, 0);
  writeFilm(folder / "a.exr", interrupted, film);
  const Files files{second, folder / "a.exr"};
  CHECK_THAT(refusalOfMerge(files), Catch::Contains("a.exr: the render was interrupted within samples 4:5") &&
                                        Catch::Contains("with resume first") && Catch::Contains("with partial"));
  const MergedFilm merged = mergeFilms(files, {.mixedDevices = false, .partial = true});
  CHECK(merged.header.begun == std::vector{SampleBox{kWhole.window, {4, 5}}});
  CHECK(merged.missing == std::vector{SampleBox{kWhole.window, {5, 6}}});
  writeFilm(folder / "c.exr", merged.header, merged.film);
  CHECK(refusalOf(folder / "c.exr").empty());
}

TEST_CASE("films of very many boxes are read and merged, unless the result could not be read") {
  const TemporaryFolder folder;
  constexpr std::uint32_t kSide = 32, kRanges = 256;
  FilmHeader header = madeHeader({kSide, kSide}, 2 * kRanges);
  // The pixels of one colour of a chessboard have every other sample from `first` on.
  const auto writePixels = [&](const char* name, std::uint32_t colour, std::uint32_t first) {
    header.covered.clear();
    image::Film film(kSide, kSide);
    for (std::uint32_t i = 0; i < kSide * kSide; ++i) {
      const std::uint32_t x = i % kSide, y = i / kSide;
      if ((x + y) % 2 != colour) continue;
      for (std::uint32_t sample = first; sample < 2 * kRanges; sample += 2) {
        film.addSample(x, y, glm::dvec3(1), sample);
        header.covered.push_back({{x, y, 1, 1}, {sample, sample + 1}});
      }
    }
    writeFilm(folder / name, header, film);
    return folder / name;
  };
  const auto white = writePixels("white.exr", 0, 0);
  REQUIRE(FilmReader(white).header().covered.size() == kMaxBoxes);
  CHECK(refusalOf(white).empty());
  const MergeOptions partial{.mixedDevices = false, .partial = true};
  const MergedFilm merged = mergeFilms(Files{white, writePixels("same.exr", 1, 0)}, partial);
  CHECK(merged.header.covered.size() == kRanges);
  CHECK(merged.header.covered.back() == SampleBox{{0, 0, kSide, kSide}, {2 * kRanges - 2, 2 * kRanges - 1}});
  CHECK_THAT(refusalOfMerge({white, writePixels("other.exr", 1, 1)}, partial),
             Catch::Contains("262144 boxes") && Catch::Contains("merge films that adjoin first"));
}

TEST_CASE("a merge names a shard that is damaged or not a film") {
  const TemporaryFolder folder;
  const Files files = writeParts(folder, 1, 1, 3);
  std::string bytes = bytesOf(files[1]);
  bytes[bytes.size() - 20] = static_cast<char>(bytes[bytes.size() - 20] ^ 4);
  writeBytes(files[1], bytes);
  CHECK_THAT(refusalOfMerge(files), Catch::Contains("part1.exr: the file is damaged"));
}

TEST_CASE("the work of all parts is added up, and parts without a report are counted") {
  const TemporaryFolder folder;
  const Files files = writeParts(folder, 1, 1, 3);
  WorkReport work;
  work.runs = 2;
  work.hosts = {"a"};
  work.counts = {{"shadowRays", 10}};
  work.seconds = {{"trace", 1.5}};
  writeWork(files[0], FilmReader(files[0]).check(), work);
  work.hosts = {"b"};
  writeWork(files[1], FilmReader(files[1]).check(), work);
  writeWork(files[2], "00000000", work);
  const WorkReport sum = mergeFilms(files, {}).work;
  CHECK(sum.runs == 4);
  CHECK(sum.runsNotCounted == 1);
  CHECK(sum.hosts == std::set<std::string>{"a", "b"});
  CHECK(sum.counts.at("shadowRays") == 20);
  CHECK(sum.seconds.at("trace") == 3);
}
