// Alpha and the channels of layers are compared by name.
#include "host/image/channel_comparison.h"

#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "host/base/errors.h"

using namespace candela;
using namespace candela::image;

namespace {

constexpr float kNoNumber = std::numeric_limits<float>::quiet_NaN();
constexpr float kEndless = std::numeric_limits<float>::infinity();

Image pixels(std::vector<Channel> channels, std::vector<float> alpha = {}) {
  Image image;
  image.width = 2;
  image.height = 1;
  image.rgb = {glm::vec3(1, 2, 3), glm::vec3(4, 5, 6)};
  image.alpha = std::move(alpha);
  image.channels = std::move(channels);
  return image;
}

std::vector<std::string> namesOf(const ChannelComparison& comparison) {
  std::vector<std::string> names;
  for (const ChannelDifference& channel : comparison.channels) names.push_back(channel.name);
  return names;
}

}  // namespace

TEST_CASE("alpha is compared if one of the images has it, and is 1 in the other") {
  const ChannelComparison both = compareChannels(pixels({}, {0.25f, 0.5f}), pixels({}, {0.25f, 1}));
  REQUIRE(namesOf(both) == std::vector<std::string>{"A"});
  CHECK(both.channels[0].differingCount == 1);
  CHECK(both.channels[0].maximumDifference == 0.5);
  CHECK(both.channels[0].maximumX == 1);
  CHECK(both.channels[0].relativeMeanSquaredError == Approx(0.25 / 1.01 / 2));
  CHECK(compareChannels(pixels({}, {1, 1}), pixels({})).channels.at(0).isEqual());
  CHECK(compareChannels(pixels({}, {0, 1}), pixels({})).channels.at(0).differingCount == 1);
  CHECK(compareChannels(pixels({}), pixels({})).channels.empty());
}

TEST_CASE("channels that both images have are compared, and the others are named") {
  const ChannelComparison c = compareChannels(pixels({{"N.X", {1, 1}}, {"Z", {1, 1e10f}}}),
                                              pixels({{"Z", {1, 2}}, {"albedo.R", {1, 1}}}));
  REQUIRE(namesOf(c) == std::vector<std::string>{"Z"});
  CHECK(c.channels[0].relativeMeanSquaredError == Approx(0.5));  // a depth of nothing is one wrong pixel
  CHECK(!c.channels[0].isWithin(0.49));
  CHECK(c.channels[0].isWithin(0.51));
  CHECK(c.onlyInA == std::vector<std::string>{"N.X"});
  CHECK(c.onlyInB == std::vector<std::string>{"albedo.R"});
  const std::string text = toText(c);
  CHECK_THAT(text, Catch::Contains("only in A             N.X\n"));
  CHECK_THAT(text, Catch::Contains("only in B             albedo.R\n"));
}

TEST_CASE("ids are compared bit by bit") {
  const float one = std::bit_cast<float>(0x7f800001u), other = std::bit_cast<float>(0x7f800002u);  // both NaN
  const auto ids = [](float id) { return pixels({{"id", {0.5f, id}, true}}); };
  CHECK(compareChannels(ids(one), ids(one)).channels.at(0).isEqual());
  const ChannelComparison c = compareChannels(ids(one), ids(other));
  CHECK(c.channels.at(0).differingCount == 1);
  CHECK(c.channels[0].maximumX == 1);
  CHECK(!c.channels[0].isWithin(1e30));
  CHECK_THAT(toText(c), Catch::Contains("1 pixels have other ids, the first at 1 0"));
  CHECK(!compareChannels(ids(0), ids(-0.0f)).channels.at(0).isEqual());
}

TEST_CASE("values that are not finite exceed any tolerance, unless they are equal") {
  const auto depths = [](float depth) { return pixels({{"Z", {depth, 1}}}); };
  CHECK(compareChannels(depths(kEndless), depths(kEndless)).channels.at(0).isEqual());
  CHECK(compareChannels(depths(kNoNumber), depths(kNoNumber)).channels.at(0).isEqual());
  for (const float odd : {kEndless, kNoNumber}) {
    const ChannelComparison c = compareChannels(depths(odd), depths(1));
    CHECK(c.channels.at(0).notFiniteCount == 1);
    CHECK(!c.channels[0].isWithin(1e30));
  }
}

TEST_CASE("channels are selected by their names, by layers, and by what stands before the full stop") {
  const Image image = pixels({{"N.X", {1, 1}}, {"N.Y", {1, 1}}, {"Z", {1, 1}}}, {1, 0});
  const auto selected = [&](const std::vector<std::string>& words) {
    return namesOf(compareChannels(image, image, words));
  };
  CHECK(selected({"N"}) == std::vector<std::string>{"N.X", "N.Y"});
  CHECK(selected({"normal"}) == std::vector<std::string>{"N.X", "N.Y"});
  CHECK(selected({"depth", "N.Y", "Z"}) == std::vector<std::string>{"Z", "N.Y"});
  CHECK(selected({"A"}) == std::vector<std::string>{"A"});
  CHECK(selected({"R", "G"}) == std::vector<std::string>{"R", "G"});
  CHECK(selected({"B", "R", "G"}).empty());  // the picture
  CHECK(compareChannels(image, image, {"B", "R", "G"}).comparesColours);
  CHECK(!compareChannels(image, image, {"R"}).comparesColours);
  CHECK_THROWS_WITH(compareChannels(image, image, {"M"}),
                    Catch::Contains("A has no channel \"M\"") && Catch::Contains("R, G, B, A, N.X, N.Y, Z"));
  CHECK_THROWS_WITH(compareChannels(image, pixels({{"N.X", {1, 1}}}), {"N"}),
                    Catch::Contains("\"N.Y\", and B has not"));
  CHECK_THROWS_AS(compareChannels(pixels({}), image, {"Z"}), UsageError);
}

TEST_CASE("the comparison of channels has a JSON form") {
  nlohmann::ordered_json json;
  addToJson(compareChannels(pixels({{"Z", {1, 3}}}), pixels({{"Z", {1, 2}}})), json);
  CHECK(json["comparesColours"] == true);
  CHECK(json["channels"][0]["name"] == "Z");
  CHECK(json["channels"][0]["worst"]["difference"] == 1.0);
  CHECK(json["channels"][0]["worst"]["x"] == 1);
  CHECK(json["onlyInA"].empty());
}
