// Reports of work: a written report is read again, and any other file counts as no report.
#include "host/job/film/work_report.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/base/temporary_folder.h"
#include "tests/job/film/made_films.h"

using namespace candela;
using namespace candela::film;

TEST_CASE("a report of work is read for the film that it belongs to, and for no other") {
  const TemporaryFolder folder;
  render::RenderStatistics statistics;
  statistics.samples = 5;
  statistics.shadowRays = std::uint64_t{1} << 40;
  statistics.treeRays = render::TreeRays{1, 2, 3};
  statistics.seconds = {{"trace", 0.25}};
  const WorkReport work = workOf(statistics);
  CHECK(work.counts.at("reflectedRays") == 2);
  writeWork(folder / "a.exr", "0a1b2c3d", work);
  CHECK(toJson(readWork(folder / "a.exr", "0a1b2c3d")) == toJson(work));
  CHECK(readWork(folder / "a.exr", "0a1b2c3e").runsNotCounted == 1);
  CHECK(readWork(folder / "b.exr", "0a1b2c3d").runsNotCounted == 1);
}

TEST_CASE("a file that is not a report counts as a run without counts") {
  const TemporaryFolder folder;
  for (const char* text :
       {"", "{", "[]", "{\"film\":\"x\"}", "{\"film\":\"x\",\"runs\":\"two\"}",
        "{\"film\":\"x\",\"runs\":1,\"runsNotCounted\":0,\"hosts\":[1],\"counts\":{},\"seconds\":{}}",
        "{\"film\":\"x\",\"runs\":-1,\"runsNotCounted\":0,\"hosts\":[],\"counts\":{},\"seconds\":{}}",
        "{\"film\":\"x\",\"runs\":1,\"runsNotCounted\":0.5,\"hosts\":[],\"counts\":{},\"seconds\":{}}",
        "{\"film\":\"x\",\"runs\":1,\"runsNotCounted\":0,\"hosts\":[],\"counts\":{\"samples\":1e300},\"seconds\":{}"
        "}"}) {
    writeBytes(folder / "a.exr.json", text);
    INFO(text);
    const WorkReport work = readWork(folder / "a.exr", "x");
    CHECK(work.runs == 0);
    CHECK(work.runsNotCounted == 1);
  }
}
