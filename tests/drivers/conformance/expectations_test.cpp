// Baselines and lists of patterns, in the files of deqp-runner.
#include "host/drivers/conformance/expectations.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <iterator>

#include "host/base/errors.h"
#include "host/drivers/conformance/case_tables.h"

namespace candela::conformance {
namespace {

using Catch::Contains;

constexpr const char* kFiles = CANDELA_SOURCE_DIR "/tests/drivers/conformance/files/";
constexpr const char* kBaselines = CANDELA_SOURCE_DIR "/host/drivers/conformance/baselines/";

}  // namespace

TEST_CASE("a file of results that deqp-runner wrote is a baseline") {
  const Baseline baseline = readBaseline(std::string(kFiles) + "deqp_results.csv");
  CHECK(baseline.size() == 11);
  CHECK(baseline.at("dEQP-VK.glsl.loops.generic.for_constant_iterations.nested_sequence_compute") == Status::fail);
  CHECK(baseline.at("dEQP-VK.memory.pipeline_barrier.host_write_uniform_buffer.1024") == Status::crash);
  CHECK(baseline.at("dEQP-VK.graphicsfuzz.cov-nested-loops-sample-opposite-corners") == Status::timeout);
  CHECK(baseline.at("dEQP-VK.rasterization.interpolation.basic.lines") == Status::expectedFail);
  CHECK(baseline.at("dEQP-VK.query_pool.occlusion_query.basic_conservative") == Status::flake);
  CHECK(baseline.at("dEQP-VK.glsl.builtin.precision.sqrt.compute.scalar") == Status::pass);
  CHECK(baseline.at("dEQP-VK.info.build") == Status::pass);
}

TEST_CASE("a line of a baseline that cannot be read is an error with its place") {
  CHECK_THROWS_WITH(parseBaseline("a.b,Fail\n\n# c\nd.e\n", "fails.txt"),
                    Contains("fails.txt:4: expected `case,Result`") && Contains("d.e"));
  CHECK_THROWS_WITH(parseBaseline("a.b,Failed\n", "fails.txt"), Contains("fails.txt:1: unknown result \"Failed\""));
  CHECK_THROWS_WITH(parseBaseline("a.b,Fail\na.b,Crash\n", "fails.txt"), Contains("fails.txt:2: a.b occurs twice"));
  CHECK_THROWS_AS(readBaseline("/nonexistent/fails.txt"), FileError);
  CHECK(parseBaseline("a.b,Fail\r\n", "fails.txt").at("a.b") == Status::fail);
  CHECK(parseBaseline("\xef\xbb\xbf"
                      "a.b,Fail\n",
                      "fails.txt")
            .at("a.b") == Status::fail);
  CHECK(NamePatterns("\xef\xbb\xbf^a$\n", "skips.txt").match("a"));
}

TEST_CASE("patterns match anywhere in a name unless they are anchored") {
  const NamePatterns skips = readPatterns(std::string(kFiles) + "deqp_skips.txt");
  CHECK(skips.match("kernel.wavefront.scene.terrain"));
  CHECK(skips.match("dEQP-VK.api.object_management.max_concurrent.buffer"));
  CHECK(skips.match("prefix.memory.command.copy"));
  CHECK_FALSE(skips.match("prefix.kernel.wavefront.scene"));
  CHECK_FALSE(skips.match("memory.command.copy_twice"));
  CHECK_FALSE(skips.match("These take minutes"));
  CHECK_FALSE(NamePatterns().match("a"));
}

TEST_CASE("a wrong regular expression is an error with its line") {
  CHECK_THROWS_WITH(NamePatterns("a.*\n(b\n", "skips.txt"),
                    Contains("skips.txt:2: \"(b\" is not a valid regular expression"));
}

TEST_CASE("the baselines that are shipped name cases that exist") {
  Cases cases = allCases();
  std::ranges::move(variantCases(), std::back_inserter(cases));
  for (const char* const file : {"lavapipe-22.3.6-fails.txt", "lavapipe-25.0.7-fails.txt", "lavapipe-26.1.6-fails.txt",
                                 "lavapipe-26.2.6-fails.txt", "swiftshader-fails.txt"}) {
    const Baseline baseline = readBaseline(std::string(kBaselines) + file);
    CHECK_FALSE(baseline.empty());
    for (const auto& [name, status] : baseline) {
      CAPTURE(file, name);
      CHECK(std::ranges::count(cases, name, &Case::name) == 1);
    }
  }
}

TEST_CASE("the two faults of lavapipe 22.3.6 are in its baseline") {
  const Baseline baseline = readBaseline(std::string(kBaselines) + "lavapipe-22.3.6-fails.txt");
  CHECK(baseline.at("control.loop.iterations") == Status::fail);
  CHECK(baseline.at("control.loop.ended_in_the_middle") == Status::fail);
}

TEST_CASE("names of cases are unique, and a pattern selects some of them") {
  const Cases cases = allCases();
  for (const Case& one : cases) {
    CAPTURE(one.name);
    CHECK(std::ranges::count(cases, one.name, &Case::name) == 1);
    CHECK(one.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789._") == std::string::npos);
  }
  CHECK(casesNamed(cases, {"*"}).size() == cases.size());
  CHECK(casesNamed(cases, {"kernel.megakernel.layout.cwbvh.texel.cornell"}).size() == 1);
  CHECK(casesNamed(cases, {"leaf.sampler.*"}).size() == 4);
  CHECK(casesNamed(cases, {"none"}).empty());
}

}  // namespace candela::conformance
