// The description of a film: canonical JSON, in which no other member or value is accepted.
#include "host/job/film/film_header.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "host/base/errors.h"
#include "host/job/film/film_head.h"
#include "tests/job/film/made_films.h"

using namespace candela;
using namespace candela::film;
using nlohmann::ordered_json;

namespace {

FilmHeader fullHeader() {
  FilmHeader header = madeHeader({64, 48}, 128);
  header.window = {8, 4, 40, 30};
  header.covered = {{{8, 4, 40, 30}, {0, 16}}};
  header.begun = {{{8, 4, 40, 30}, {16, 20}}};
  header.tracers.push_back({"b", "", "p", "reference", "1.0"});
  header.mixed = {"--seed is 1 in an earlier part and 7 in a later part"};
  return header;
}

}  // namespace

TEST_CASE("a header survives conversion to JSON and back") {
  CHECK(headerFromJson(toJson(fullHeader())) == fullHeader());
  const FilmHeader plain = madeHeader({1, 65535}, 1);
  CHECK(headerFromJson(toJson(plain)) == plain);
}

TEST_CASE("names that are not ASCII survive as ASCII text") {
  FilmHeader header = fullHeader();
  header.tracers[0].device = "Gerät";
  const std::string text = toJson(header);
  CHECK(std::ranges::all_of(text, [](char c) { return c > 0; }));
  CHECK(headerFromJson(text) == header);
}

TEST_CASE("every member of a description that is impossible is refused by its pointer") {
  struct Edit {
    const char* member;
    const char* value;
    const char* message;
  };
  for (const auto& [member, value, message] : std::vector<Edit>{
           {"scene", "\"0123\"", "/scene: expected 16 hexadecimal digits"},
           {"scene", "7", "/scene: expected a string"},
           {"scene", "\"0123456789ABCDEF\"", "/scene: expected 16 hexadecimal digits"},
           {"size", "[64]", "/size: expected 2 elements"},
           {"size", "[0,48]", "/size/0: expected a whole number from 1 to 65535"},
           {"size", "[65536,48]", "/size/0: expected a whole number from 1 to 65535"},
           {"size", "[65535,65535]", "/size: the image has too many pixels"},
           {"size", "[64.5,48]", "/size/0: expected a whole number from 1 to 65535"},
           {"size", "null", "/size: expected an array"},
           {"samplesPerPixel", "0", "/samplesPerPixel: expected a whole number from 1 to 1073741824"},
           {"samplesPerPixel", "-1", "/samplesPerPixel: expected a whole number from 1 to 1073741824"},
           {"samplesPerPixel", "1073741825", "/samplesPerPixel: expected a whole number from 1 to 1073741824"},
           {"samplesPerPixel", "18446744073709551616",
            "/samplesPerPixel: expected a whole number from 1 to 1073741824"},
           {"seed", "4294967296", "/seed: expected a whole number from 0 to 4294967295"},
           {"settings", "[]", "/settings: expected an object"},
           {"settings", "{\"a\":1}", "/settings/a: expected a string"},
           {"window", "[8,4,40]", "/window: expected 4 elements"},
           {"window", "[8,4,57,30]", "/window: the window exceeds the image"},
           {"window", "[4294967295,4,2,30]", "/window/0: expected a whole number from 0 to 63"},
           {"covered", "[[8,4,40,30,0]]", "/covered/0: expected 6 elements"},
           {"covered", "[[8,4,40,30,3,3]]", "/covered/0/5: expected a whole number from 4 to 128"},
           {"covered", "[[8,4,40,30,0,129]]", "/covered/0/5: expected a whole number from 1 to 128"},
           {"covered", "[[7,4,40,30,0,16]]", "/covered: a box exceeds the window"},
           {"covered", "[[8,4,40,30,0,8],[8,4,40,30,8,16]]",
            "/covered: the boxes overlap, or are not in the form that is written"},
           {"covered", "[[8,4,40,30,0,8],[8,4,40,30,7,16]]",
            "/covered: the boxes overlap, or are not in the form that is written"},
           {"begun", "[[8,4,40,30,15,20]]", "/begun: the boxes overlap those of \"covered\""},
           {"begun", "{}", "/begun: expected an array"},
           {"tracers", "[]", "/tracers: expected at least one tracer"},
           {"tracers", "[{}]", "/tracers/0: the property \"device\" is missing"},
           {"mixed", "[\"b\",\"a\"]", "/mixed: expected different elements in ascending order"},
           {"mixed", "[\"a\",\"a\"]", "/mixed: expected different elements in ascending order"},
           {"mixed", "[1]", "/mixed/0: expected a string"}}) {
    ordered_json json = ordered_json::parse(toJson(fullHeader()));
    json[member] = ordered_json::parse(value);
    INFO(member << " " << value);
    CHECK_THROWS_WITH(headerFromJson(json.dump()), std::string("the description of the film: ") + message);
  }
  CHECK_THROWS_WITH(headerFromJson("{\"format\":"), Catch::Contains("the description of the film: not valid JSON"));
  CHECK_THROWS_WITH(headerFromJson("[]"), "the description of the film: the root: expected an object");
  CHECK_THROWS_WITH(headerFromJson(std::string(100000, '[')), Catch::Contains("nested more than 256 levels"));
}

TEST_CASE("another version of the format is refused by its number") {
  ordered_json json = ordered_json::parse(toJson(fullHeader()));
  json["format"] = 8;
  CHECK_THROWS_WITH(headerFromJson(json.dump()),
                    Catch::Contains("has version 8") && Catch::Contains("reads versions 1 to 7"));
}

TEST_CASE("only films with alpha have version 2 of the format") {
  FilmHeader header = fullHeader();
  CHECK(ordered_json::parse(toJson(header))["format"] == 1);
  CHECK_FALSE(header.hasAlpha());
  header.settings["background"] = "colour";
  CHECK(ordered_json::parse(toJson(header))["format"] == 1);
  header.settings["background"] = "none";
  CHECK(header.hasAlpha());
  ordered_json json = ordered_json::parse(toJson(header));
  CHECK(json["format"] == 2);
  CHECK(headerFromJson(json.dump()) == header);
  json["format"] = 1;
  CHECK_THROWS_WITH(headerFromJson(json.dump()),
                    Catch::Contains("/format: a film with these settings and layers has version"));
  json["format"] = 2;
  json["settings"].erase("background");
  CHECK_THROWS_WITH(headerFromJson(json.dump()),
                    Catch::Contains("/format: a film with these settings and layers has version"));
}

TEST_CASE("films with layers have version 3 of the format, and list them in their order") {
  FilmHeader header = fullHeader();
  header.layers.add(image::Layer::direct);
  header.layers.add(image::Layer::normal);
  const ordered_json json = ordered_json::parse(toJson(header));
  CHECK(json["format"] == 3);
  CHECK(json["layers"] == ordered_json{"normal", "direct"});
  CHECK(headerFromJson(json.dump()) == header);
  header.settings["background"] = "none";
  CHECK(headerFromJson(toJson(header)) == header);
  CHECK(header.format() == 3);
}

TEST_CASE("adaptively sampled films have version 6 of the format, and those of the first rule version 4") {
  FilmHeader header = fullHeader();
  header.settings["noise-threshold"] = "0.2";
  FilmHeader current = header;
  current.settings["stopping-rule"] = "2";
  CHECK(header.format() == 4);
  CHECK(headerFromJson(toJson(header)) == header);
  CHECK_FALSE(planOf(header));
  CHECK(current.format() == 6);
  CHECK(headerFromJson(toJson(current)) == current);
  CHECK(planOf(current));
  CHECK(estimateDifferences(header, current, "A", "B") ==
        std::vector<std::string>{"stopping-rule is absent in A and 2 in B"});
  current.layers.add(image::Layer::cryptoObject);
  CHECK(current.format() == 6);
}

TEST_CASE("films with a scale have version 7 of the format") {
  FilmHeader header = fullHeader();
  CHECK(header.filmScale() == 0);
  header.settings["film-scale"] = "17";
  CHECK(header.format() == 7);
  CHECK(header.filmScale() == 17);
  CHECK(headerFromJson(toJson(header)) == header);
  header.settings["noise-threshold"] = "0.2";
  header.settings["stopping-rule"] = "2";
  header.layers.add(image::Layer::cryptoObject);
  CHECK(header.format() == 7);
  CHECK(headerFromJson(toJson(header)) == header);
  CHECK(estimateDifferences(fullHeader(), headerFromJson(toJson(header)), "A", "B").front() ==
        "film-scale is absent in A and 17 in B");
}

TEST_CASE("scales that no film has are refused") {
  FilmHeader header = fullHeader();
  for (const char* scale : {"0", "41", "-1", "017", "1.5", "", "auto"}) {
    CAPTURE(scale);
    header.settings["film-scale"] = scale;
    CHECK_THROWS_WITH(headerFromJson(toJson(header)), Catch::Contains("scale of the film"));
  }
}

TEST_CASE("films by unknown rules of stopping are refused") {
  FilmHeader header = fullHeader();
  header.settings["noise-threshold"] = "0.2";
  header.settings["stopping-rule"] = "3";
  CHECK_THROWS_WITH(headerFromJson(toJson(header)), Catch::Contains("/settings/stopping-rule"));
  header.settings["stopping-rule"] = "2";
  header.settings.erase("noise-threshold");
  CHECK_THROWS_WITH(headerFromJson(toJson(header)), Catch::Contains("/settings/stopping-rule"));
}

TEST_CASE("a list of layers that no film has is refused") {
  FilmHeader header = fullHeader();
  header.layers.add(image::Layer::normal);
  const ordered_json good = ordered_json::parse(toJson(header));
  for (const char* list : {R"(["albedo","normal"])", R"(["normal","normal"])", R"(["normal","samples"])",
                           R"(["normals"])", R"([1])", R"("normal")"}) {
    CAPTURE(list);
    ordered_json json = good;
    json["layers"] = ordered_json::parse(list);
    CHECK_THROWS_WITH(headerFromJson(json.dump()), Catch::Contains("the description of the film: /layers"));
  }
  for (const std::uint32_t format : {1u, 2u}) {
    ordered_json json = good;
    json["format"] = format;
    CHECK_THROWS_WITH(headerFromJson(json.dump()),
                      Catch::Contains("/format: a film with these settings and layers has version"));
  }
  ordered_json json = good;
  json["layers"] = ordered_json::array();
  CHECK_THROWS_WITH(headerFromJson(json.dump()),
                    Catch::Contains("/format: a film with these settings and layers has version"));
}

TEST_CASE("films with other layers are different estimates") {
  FilmHeader a = fullHeader(), b = a;
  b.layers.add(image::Layer::depth);
  CHECK(estimateDifferences(a, b, "A", "B") == std::vector<std::string>{"aov is none in A and depth in B"});
}

TEST_CASE("the coverage of an interrupted film is what all pixels have, and what some have") {
  FilmHeader header = madeHeader({2, 2}, 16);
  image::Film film(2, 2);
  CHECK_FALSE(firstSampleOf(header));
  setCoverage(header, film, 3);
  CHECK((header.covered.empty() && header.begun.empty()));
  film.at(0, 0).sampleCount = 5;
  setCoverage(header, film, 3);
  CHECK(header.covered.empty());
  CHECK(header.begun == std::vector{SampleBox{{0, 0, 2, 2}, {3, 8}}});
  CHECK(firstSampleOf(header) == 3u);
  for (image::FilmPixel& pixel : film.pixels()) pixel.sampleCount += 2;
  setCoverage(header, film, 3);
  CHECK(header.covered == std::vector{SampleBox{{0, 0, 2, 2}, {3, 5}}});
  CHECK(header.begun == std::vector{SampleBox{{0, 0, 2, 2}, {5, 10}}});
  CHECK(firstSampleOf(header) == 3u);
  header.begun[0].samples.first = 6;
  CHECK_FALSE(firstSampleOf(header));
}

TEST_CASE("differences of two films are named, the scene first") {
  const FilmHeader a = fullHeader();
  CHECK(estimateDifferences(a, a, "A", "B").empty());
  FilmHeader b = a;
  b.settings["sampler"] = "stratified";
  b.settings.erase("integrator");
  b.seed = 8;
  b.sceneHash = "ffffffffffffffff";
  CHECK(estimateDifferences(a, b, "A", "B") ==
        std::vector<std::string>{"the scene's hash is 0123456789abcdef in A and ffffffffffffffff in B",
                                 "seed is 7 in A and 8 in B", "integrator is path in A and absent in B",
                                 "sampler is sobol in A and stratified in B"});
  CHECK(tracerDifferences(a.tracers[0], {"a device", "a driver", "a platform", "x", "1.0"}, "A", "B") ==
        std::vector<std::string>{"the hash of the kernels is kernels in A and x in B"});
}

TEST_CASE("a description of more boxes than a film file may have is refused") {
  FilmHeader header = madeHeader({64, 48}, 1u << 30);
  const auto addBoxes = [](std::vector<SampleBox>& boxes, std::uint32_t y, std::size_t count) {
    for (std::uint32_t i = 0; i < count; ++i) boxes.push_back({{0, y, 64, 1}, {2 * i, 2 * i + 1}});
  };
  addBoxes(header.covered, 0, kMaxBoxes - 1);
  addBoxes(header.begun, 1, 1);
  CHECK(headerFromJson(toJson(header)) == header);
  CHECK(toJson(header).size() < kMaxHeadBytes / 2);
  addBoxes(header.begun, 3, 1);
  CHECK_THROWS_WITH(headerFromJson(toJson(header)),
                    "the description of the film: /begun: expected at most 131072 boxes in both lists");
  addBoxes(header.covered, 1, 2);
  CHECK_THROWS_WITH(headerFromJson(toJson(header)),
                    "the description of the film: /covered: expected at most 131072 boxes");
}

// If parsing a member took a time proportional to the number of members, this would exceed the time limit of a test.
TEST_CASE("a description may have any number of members") {
  FilmHeader header = madeHeader({64, 48}, 1);
  for (int i = 0; i < 300000; ++i) header.settings[std::to_string(i)] = "";
  CHECK(headerFromJson(toJson(header)).settings.size() == header.settings.size());
}
