// Lists of pictures and times of several tracers: reading, figures, and lists that are refused.
#include "host/measure/bench/error_report.h"

#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>

#include "host/base/errors.h"
#include "tests/base/temporary_folder.h"

namespace candela::bench {
namespace {

using Catch::Contains;
using Json = nlohmann::json;

// Writes pictures of one pixel and lists that name them.
class Lists {
 public:
  std::string picture(float value, std::uint32_t width = 1) {
    image::Image picture;
    picture.width = width;
    picture.height = 1;
    picture.rgb.assign(width, glm::vec3(value));
    const std::string name = std::to_string(count_++) + ".exr";
    writeImage(folder_ / name, picture, {});
    return name;
  }
  Json run(float value, double seconds) {
    return {{"file", picture(value)}, {"seconds", seconds}, {"processorSeconds", 2 * seconds}};
  }
  Json tracer(const std::string& name, std::vector<Json> runs, float referenceValue = 2) {
    return {{"tracer", name},
            {"tracerVersion", name + " 1.0"},
            {"samplesPerPixel", 16},
            {"pictures", std::move(runs)},
            {"reference", {picture(referenceValue), picture(referenceValue)}}};
  }
  std::filesystem::path write(const std::vector<Json>& tracers) {
    return writeText(Json{{"schema", "candela-error-runs/1"}, {"scene", "box"}, {"tracers", tracers}}.dump());
  }
  std::filesystem::path writeText(const std::string& text) {
    const std::filesystem::path file = folder_ / (std::to_string(count_++) + ".json");
    std::ofstream(file) << text;
    return file;
  }

 private:
  TemporaryFolder folder_;
  int count_ = 0;
};

ErrorReport read(const std::filesystem::path& list) { return readErrorRuns({&list, 1}); }

TEST_CASE("the figures of a list are those of its pictures and times") {
  Lists lists;
  const ErrorReport report = read(lists.write(
      {lists.tracer("A", {lists.run(3, 1), lists.run(1, 1)}), lists.tracer("B", {lists.run(4, 9), lists.run(0, 9)})}));
  REQUIRE(report.rows.size() == 2);
  CHECK(report.rows[0].error.relMse().value == Approx(1 / 4.01));
  CHECK(report.rows[0].error.errorAfterSecond().value == Approx(std::sqrt(1 / 4.01)));
  CHECK(report.rows[0].processorError->errorAfterSecond().value == Approx(std::sqrt(2 / 4.01)));
  CHECK(report.rows[1].error.inefficiency().value == Approx(9 * 4 / 4.01));
  const nlohmann::ordered_json document = toJson(report);
  CHECK(document["schema"] == "candela-bench-error/1");
  CHECK_FALSE(document["rows"][0].contains("errorRatio"));
  CHECK(document["rows"][1]["errorRatio"] == Approx(6));  // the root of 9 x 4
  CHECK(document["rows"][1]["processorErrorRatio"] == Approx(6));
  CHECK(document["rows"][1]["tracerVersion"] == "B 1.0");
  CHECK_THAT(toText(report), Contains("6.00 (6.00 to 6.00)") && Contains("49.9 % (49.9 to 49.9)"));
}

TEST_CASE("converged pictures that differ are reported, and each tracer's error is that of its own noise") {
  Lists lists;
  const ErrorReport report = read(lists.write({lists.tracer("A", {lists.run(3, 1), lists.run(1, 1)}),
                                               lists.tracer("B", {lists.run(4, 1), lists.run(2, 1)}, 3)}));
  CHECK(report.rows[0].referenceRelMse == 0);
  CHECK(report.rows[1].referenceRelMse == Approx(1 / 4.01));
  CHECK(report.rows[1].error.relMse().value == Approx(1 / 9.01));
  CHECK_THAT(toText(report), Contains("box: converged pictures of B and A differ by a relMSE of 0.25 without noise"));
}

TEST_CASE("processor times are used only if every picture has one") {
  Lists lists;
  Json partly = lists.run(1, 1);
  partly.erase("processorSeconds");
  const ErrorReport report = read(lists.write({lists.tracer("A", {lists.run(3, 1), partly})}));
  CHECK_FALSE(report.rows[0].processorError);
  CHECK(toJson(report)["rows"][0]["processorSeconds"].is_null());
}

TEST_CASE("a list that is none is refused, and the message names it") {
  Lists lists;
  const Json good = lists.tracer("A", {lists.run(3, 1), lists.run(1, 1)});
  const auto refuses = [&](const std::filesystem::path& list, const std::string& message) {
    CHECK_THROWS_WITH(read(list), Contains(list.filename().string()) && Contains(message));
  };
  refuses(lists.writeText("{}"), "schema");
  refuses(lists.writeText(R"({"schema": "candela-bench/2"})"), "/schema: expected candela-error-runs/1");
  for (const char* const key : {"tracer", "samplesPerPixel", "pictures", "reference"}) {
    Json bad = good;
    bad.erase(key);
    refuses(lists.write({bad}), key);
  }
  Json bad = good;
  bad["pictures"].erase(1);
  refuses(lists.write({bad}), "/tracers/0/pictures: expected at least two pictures of different seeds");
  bad = good;
  bad["pictures"][0]["seconds"] = 0;
  refuses(lists.write({bad}), "expected a positive number of seconds");
  bad = good;
  bad["reference"][0] = lists.picture(2, 2);
  refuses(lists.write({bad}), "pictures of different sizes");
  refuses(lists.write({lists.tracer("A", {lists.run(2, 1), lists.run(2, 1)})}), "no more noise than the reference");
  bad = good;
  bad["reference"][0] = "absent.exr";
  CHECK_THROWS_WITH(read(lists.write({bad})), Contains("absent.exr"));
}

}  // namespace
}  // namespace candela::bench
