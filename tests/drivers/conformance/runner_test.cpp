// Cases in child processes: every possible result, without a device.
#include "host/drivers/conformance/runner.h"

#include <sys/mman.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <new>
#include <thread>

#include "host/base/errors.h"
#include "host/trace/vulkan/validation_log.h"

namespace candela::conformance {
namespace {

using Catch::Contains;

Finding crash(Workbench&) {
  ::raise(SIGSEGV);
  return passed();
}

Finding hang(Workbench&) {
  std::this_thread::sleep_for(std::chrono::minutes(5));
  return passed();
}

Case made(const std::string& name, const std::string& group, Finding (*run)(Workbench&)) { return {name, group, run}; }

std::map<std::string, CaseResult> byName(const RunResult& run) {
  std::map<std::string, CaseResult> results;
  for (const CaseResult& one : run.cases) results[one.name] = one;
  return results;
}

RunResult runMade(const Cases& cases, RunOptions options = {}) { return runCases(cases, {}, options); }

/// A file by which the processes of one test count the runs of a case.
class RunCount {
 public:
  RunCount() : file_(std::filesystem::temp_directory_path() / ("candela-runs-" + std::to_string(::getpid()))) {
    std::filesystem::remove(file_);
  }
  ~RunCount() { std::filesystem::remove(file_); }
  RunCount(const RunCount&) = delete;
  RunCount& operator=(const RunCount&) = delete;

  int next() const {
    std::ofstream(file_, std::ios::app) << "x";
    return static_cast<int>(std::filesystem::file_size(file_));
  }

 private:
  std::filesystem::path file_;
};

/// Counters that the processes of one test share.
class SharedCounts {
 public:
  struct Counts {
    std::atomic<int> active{0}, started{0}, slowEnded{0};
  };

  SharedCounts()
      : counts_(new (::mmap(nullptr, sizeof(Counts), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0))
                    Counts) {}
  ~SharedCounts() { ::munmap(counts_, sizeof(Counts)); }
  SharedCounts(const SharedCounts&) = delete;
  SharedCounts& operator=(const SharedCounts&) = delete;

  Counts* operator->() const { return counts_; }

 private:
  Counts* counts_;
};

}  // namespace

TEST_CASE("a run that only compiles creates the pipelines of a case, and does not run it") {
  const auto compiled = [](const std::string& name, Finding (*compile)(Workbench&)) {
    return Case{name, "g", crash, compile};
  };
  const auto results = byName(
      runMade({compiled("a.pass", [](Workbench&) { return passed(); }),
               compiled("a.skip", [](Workbench&) { return skipped("a feature"); }),
               compiled("a.error", [](Workbench&) -> Finding { throw InternalError("no pipeline"); }),
               compiled("a.crash", crash), made("a.copy", "g", crash)},
              {.compilesOnly = true}));
  CHECK(results.at("a.pass").verdict.status == Status::pass);
  CHECK(results.at("a.skip").verdict.status == Status::skip);
  CHECK(results.at("a.error").verdict.status == Status::fail);
  CHECK_THAT(results.at("a.error").text, Contains("no pipeline"));
  CHECK(results.at("a.crash").verdict.status == Status::crash);
  CHECK(results.at("a.copy").verdict.status == Status::skip);
  CHECK(results.at("a.copy").text == "the case has no shader");
}

TEST_CASE("each case ends in the result that it finds") {
  const auto results = byName(
      runMade({made("a.pass", "g", [](Workbench&) { return passed(); }),
               made("a.fail", "g", [](Workbench&) { return failed("2 is not 3"); }),
               made("a.skip", "g", [](Workbench&) { return skipped("a feature"); }),
               made("a.error", "g", [](Workbench&) -> Finding { throw InternalError("no pipeline"); }),
               made("a.after", "g", [](Workbench&) { return passed(); })}));
  REQUIRE(results.size() == 5);
  CHECK(results.at("a.pass").verdict == Verdict{Status::pass});
  CHECK(results.at("a.fail").verdict == Verdict{Status::fail});
  CHECK(results.at("a.fail").text == "2 is not 3");
  CHECK(results.at("a.skip").verdict == Verdict{Status::skip});
  CHECK(results.at("a.skip").text == "a feature");
  CHECK(results.at("a.error").verdict == Verdict{Status::fail});
  CHECK(results.at("a.error").text == "no pipeline");
  CHECK(results.at("a.after").verdict == Verdict{Status::pass});
}

TEST_CASE("a crash, a hang and a lost device fail one case, and the others of their group run") {
  const auto results = byName(
      runMade({made("a.first", "g", [](Workbench&) { return passed(); }), made("b.crash", "g", crash),
               made("c.middle", "g", [](Workbench&) { return passed(); }), made("d.hang", "g", hang),
               made("e.lost", "g", [](Workbench&) -> Finding { throw DeviceLostError("the device is lost"); }),
               made("f.exit", "g", [](Workbench&) -> Finding { std::_Exit(9); }),
               made("g.last", "g", [](Workbench&) { return passed(); })},
              {.jobs = 2, .timeout = std::chrono::milliseconds(500)}));
  REQUIRE(results.size() == 7);
  for (const char* const name : {"a.first", "c.middle", "g.last"})
    CHECK(results.at(name).verdict == Verdict{Status::pass});
  CHECK(results.at("b.crash").verdict == Verdict{Status::crash});
  CHECK_THAT(results.at("b.crash").text, Contains("crashes (Segmentation fault)"));
  CHECK(results.at("d.hang").verdict == Verdict{Status::timeout});
  CHECK_THAT(results.at("d.hang").text, Contains("does not end within 0.5 s"));
  CHECK(results.at("d.hang").seconds < 30);
  CHECK(results.at("e.lost").verdict == Verdict{Status::crash});
  CHECK(results.at("e.lost").text == "the device is lost");
  CHECK(results.at("f.exit").verdict == Verdict{Status::crash});
  CHECK_THAT(results.at("f.exit").text, Contains("exit code 9"));
}

TEST_CASE("a driver that ends the program with exit code 0 is a crash, and the run ends") {
  const auto results = byName(runMade({made("a.first", "g", [](Workbench&) { return passed(); }),
                                       made("b.exit", "g", [](Workbench&) -> Finding { std::_Exit(0); }),
                                       made("c.last", "g", [](Workbench&) { return passed(); })}));
  REQUIRE(results.size() == 3);
  CHECK(results.at("b.exit").verdict == Verdict{Status::crash});
  CHECK(results.at("b.exit").text == "the process of the case ends the program with exit code 0");
  for (const char* const name : {"a.first", "c.last"}) CHECK(results.at(name).verdict == Verdict{Status::pass});
}

TEST_CASE("a case that fails once is a flake, and one that fails twice a failure") {
  const RunCount count;
  const Cases cases{{"a.once", "g", [&](Workbench&) { return count.next() == 1 ? failed("once") : passed(); }},
                    made("b.always", "h", [](Workbench&) { return failed("always"); })};
  const RunResult run = runMade(cases);
  const auto results = byName(run);
  CHECK(results.at("a.once").verdict == Verdict{Status::flake});
  CHECK_THAT(results.at("a.once").text, Contains("run again alone, the result was Pass") && Contains("once"));
  CHECK(results.at("b.always").verdict == Verdict{Status::fail});
  CHECK_FALSE(run.isExpected());
}

TEST_CASE("if both results of a case are unexpected, the second one counts") {
  const RunCount count;
  const Cases cases{
      {"a.case", "g", [&](Workbench& bench) { return count.next() == 1 ? failed("first") : crash(bench); }}};
  const CaseResult one = runMade(cases).cases.at(0);
  CHECK(one.verdict == Verdict{Status::crash});
  CHECK_THAT(one.text, Contains("Segmentation fault") && Contains("\nin the first run, the result was Fail"));
}

TEST_CASE("second attempts run after all other cases, one at a time") {
  SharedCounts counts;
  const auto fail = [&](Workbench&) {
    const int active = ++counts->active;
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    --counts->active;
    if (counts->started++ < 4) return failed("first attempt");
    return active == 1 && counts->slowEnded == 1 ? passed() : failed("not alone");
  };
  const auto slow = [&](Workbench&) {
    std::this_thread::sleep_for(std::chrono::milliseconds(600));
    ++counts->slowEnded;
    return passed();
  };
  const Cases cases{{"a", "a", fail}, {"b", "b", fail}, {"c", "c", fail}, {"d", "d", fail}, {"e", "e", slow}};
  const RunResult run = runMade(cases, {.jobs = 5});
  REQUIRE(run.cases.size() == 5);
  for (std::size_t i = 0; i < 4; ++i) CHECK(run.cases[i].verdict == Verdict{Status::flake});
}

TEST_CASE("the run is as expected if all failures are in the baseline or in the list of flakes") {
  const Cases cases{made("a.fail", "g", [](Workbench&) { return failed("known"); }), made("b.crash", "g", crash),
                    made("c.flaky", "g", [](Workbench&) { return failed("now"); }), made("d.skipped", "g", crash)};
  RunOptions options;
  options.expectations = {parseBaseline("a.fail,Fail\nb.crash,Crash\n", "fails"), NamePatterns("skipped$", "skips"),
                          NamePatterns("flaky", "flakes")};
  const RunResult run = runMade(cases, options);
  const auto results = byName(run);
  CHECK(run.isExpected());
  CHECK(results.at("a.fail").verdict == Verdict{Status::expectedFail});
  CHECK(results.at("b.crash").verdict == Verdict{Status::expectedFail});
  CHECK(results.at("c.flaky").verdict == Verdict{Status::flake});
  CHECK(results.at("d.skipped").verdict == Verdict{Status::skip});
  options.expectations.baseline["c.flaky"] = Status::crash;
  CHECK(byName(runMade(cases, options)).at("c.flaky").verdict == Verdict{Status::flake});
}

TEST_CASE("a case that passes although the baseline says it fails is unexpected") {
  RunOptions options;
  options.expectations.baseline["a.fixed"] = Status::fail;
  const RunResult run = runMade({made("a.fixed", "g", [](Workbench&) { return passed(); })}, options);
  CHECK(run.cases.at(0).verdict == Verdict{Status::improvement, Status::pass});
  CHECK_FALSE(run.isExpected());
}

TEST_CASE("a message of the validation layer fails its case") {
  const auto results = byName(runMade({made("a.wrong", "g",
                                            [](Workbench&) {
                                              vulkan::addValidationMessage("a wrong call");
                                              return passed();
                                            }),
                                       made("b.right", "g", [](Workbench&) { return passed(); })}));
  CHECK(results.at("a.wrong").verdict == Verdict{Status::fail});
  CHECK(results.at("a.wrong").text == "validation layer: a wrong call");
  CHECK(results.at("b.right").verdict == Verdict{Status::pass});
}

TEST_CASE("a seed determines the order, and no case is lost in it") {
  Cases cases;
  for (int i = 0; i < 20; ++i) cases.push_back(made("c" + std::to_string(i), "g", [](Workbench&) { return passed(); }));
  const auto orderOf = [&](std::optional<std::uint32_t> seed) {
    std::vector<std::string> order;
    runMade(cases, {.shuffle = seed, .note = [&](const CaseResult& one) { order.push_back(one.name); }});
    return order;
  };
  CHECK(orderOf(std::nullopt).at(7) == "c7");
  CHECK(orderOf(1) == orderOf(1));
  CHECK(orderOf(1) != orderOf(2));
  CHECK(orderOf(1).size() == 20);
}

TEST_CASE("an interrupted run ends at once, with the results so far") {
  std::atomic<bool> stop{false};
  RunOptions options;
  options.stop = &stop;
  options.note = [&](const CaseResult&) { stop = true; };
  const RunResult run = runMade({made("a.pass", "g", [](Workbench&) { return passed(); }), made("b.hang", "g", hang)},
                                options);
  CHECK(run.interrupted);
  CHECK_FALSE(run.isExpected());
  CHECK(run.cases.size() == 1);
}

}  // namespace candela::conformance
