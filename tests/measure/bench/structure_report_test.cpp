// The report on acceleration structures, and the figures that it omits if images differ.
#include "host/measure/bench/structure_report.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/measure/bench/fake_renderer.h"
#include "tests/trace/reference/default_settings.h"

namespace candela::bench {
namespace {

using Catch::Contains;

StructureReport structureReportOf(std::vector<ScriptedRun> script) {
  FakeRenderer renderer(std::move(script));
  const std::vector<Variant> variants = structureVariants(render::defaultSettings());
  StructureReport report;
  for (Measurement& m : measureInterleaved(renderer, scene::Scene{}, variants, 1, {})) {
    report.rows.push_back({"room", 0x1234, std::move(m)});
  }
  return report;
}

TEST_CASE("the compared structures are a grid, a BVH with midpoint splits and a SAH BVH") {
  const auto variants = structureVariants(render::defaultSettings());
  REQUIRE(variants.size() == 3);
  CHECK(variants[0].settings.structure.accel == render::AccelKind::grid);
  CHECK(variants[1].settings.structure.accel == render::AccelKind::bvh);
  CHECK(variants[1].settings.structure.bvhSplit == render::BvhSplit::midpoint);
  CHECK(variants[2].settings.structure.accel == render::AccelKind::bvh);
  CHECK(variants[2].settings.structure.bvhSplit == render::BvhSplit::sah);
}

TEST_CASE("few primitives, which are traced as a list, are not called a BVH") {
  StructureReport report = structureReportOf({{1}, {1}, {1}});
  report.rows[2].measurement.statistics.structure = render::AccelKind::bvh;
  report.rows[2].measurement.statistics.bvhSplit = render::SplitInUse::sah;
  CHECK_THAT(toText(report), Contains("BVH, SAH") && !Contains("list"));
  report.rows[2].measurement.statistics.layout = render::LayoutInUse::list;
  CHECK_THAT(toText(report), Contains("list (too few primitives for a BVH)") && !Contains("BVH, SAH"));
}

TEST_CASE("a structure whose image differs has no figures") {
  const StructureReport report = structureReportOf({{1, 2.0}, {7, 0.5}, {1, 3.0}});
  CHECK_FALSE(report.agree());
  const auto document = toJson(report);
  CHECK(document["rows"][0]["medianSeconds"] == 2.0);
  CHECK(document["rows"][1]["agrees"] == false);
  CHECK_FALSE(document["rows"][1].contains("medianSeconds"));
  CHECK_THAT(toText(report), Contains("differs") && Contains("2.00") && !Contains("0.50"));
}

TEST_CASE("published seconds are shown beside measured ones, if there are any") {
  StructureReport report = structureReportOf({{1}, {1}, {1}});
  CHECK(report.agree());
  CHECK_THAT(toText(report), !Contains("published"));
  report.rows[0].publishedSeconds = 361.0;
  CHECK_THAT(toText(report), Contains("published s") && Contains("361.0"));
  CHECK_THAT(toMarkdown(report), Contains("| 361.0 |"));
  CHECK(toJson(report)["rows"][0]["publishedSeconds"] == 361.0);
}

TEST_CASE("JSON has the schema, and the scene, images and rates of each row") {
  const auto document = toJson(structureReportOf({{1}, {1}, {1}}));
  CHECK(document["schema"] == "candela-bench/2");
  const auto& row = document["rows"][0];
  for (const char* key :
       {"scene", "sceneHash", "filmHash", "workgroup", "segmentsPerDispatch", "kernel", "layout", "msamplesPerSecond",
        "mraysPerSecond", "medianSeconds", "spread", "buildSeconds", "stepsPerRay"}) {
    CHECK(row.contains(key));
  }
  CHECK(row["sceneHash"] == "0000000000001234");
}

}  // namespace
}  // namespace candela::bench
