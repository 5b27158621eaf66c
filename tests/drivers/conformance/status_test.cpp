// The rules of deqp-runner for results and baselines.
#include "host/drivers/conformance/status.h"

#include <catch2/catch.hpp>

namespace candela::conformance {

TEST_CASE("without a baseline a result stays what it is") {
  for (const Status found : {Status::pass, Status::fail, Status::skip, Status::crash, Status::timeout}) {
    CHECK(judge(found, std::nullopt) == Verdict{found});
    CHECK(judge(found, Status::pass) == Verdict{found});
    CHECK(judge(found, Status::skip) == Verdict{found});
  }
}

TEST_CASE("a result that the baseline states is expected, and a better one is an improvement") {
  using enum Status;
  struct Rule {
    Status found, baseline;
    Verdict verdict;
  };
  const Rule rule = GENERATE(values<Rule>({{fail, fail, {expectedFail}},
                                           {crash, crash, {expectedFail}},
                                           {timeout, timeout, {expectedFail}},
                                           {fail, expectedFail, {expectedFail}},
                                           {crash, expectedFail, {expectedFail}},
                                           {timeout, expectedFail, {timeout}},
                                           {pass, expectedFail, {improvement, pass}},
                                           {skip, expectedFail, {improvement, skip}},
                                           {fail, crash, {improvement, fail}},
                                           {fail, timeout, {improvement, fail}},
                                           {crash, fail, {crash}},
                                           {timeout, fail, {timeout}},
                                           {crash, timeout, {crash}},
                                           {pass, fail, {improvement, pass}},
                                           {pass, crash, {improvement, pass}},
                                           {skip, timeout, {improvement, skip}},
                                           {pass, flake, {pass}},
                                           {fail, flake, {fail}}}));
  CAPTURE(textOf({rule.found}), textOf({rule.baseline}));
  CHECK(judge(rule.found, rule.baseline) == rule.verdict);
}

TEST_CASE("success is what deqp-runner counts as success") {
  using enum Status;
  for (const Status good : {pass, skip, flake, expectedFail}) CHECK(Verdict{good}.isExpected());
  for (const Status bad : {fail, crash, timeout, improvement}) CHECK_FALSE(Verdict{bad}.isExpected());
}

TEST_CASE("results are written and read in the words of deqp-runner") {
  CHECK(textOf({Status::improvement, Status::pass}) == "UnexpectedImprovement(Pass)");
  CHECK(textOf({Status::improvement, Status::fail}) == "UnexpectedImprovement(Fail)");
  for (const char* const word : {"Pass", "Fail", "Skip", "Crash", "Timeout", "Flake", "ExpectedFail",
                                 "UnexpectedImprovement(Pass)", "UnexpectedImprovement(Skip)"}) {
    REQUIRE(verdictNamed(word));
    CHECK(textOf(*verdictNamed(word)) == word);
  }
  CHECK(verdictNamed("KnownFlake") == Verdict{Status::flake});
  CHECK(verdictNamed("Missing") == Verdict{Status::fail});
  for (const char* const word : {"", "pass", "Passed", "UnexpectedImprovement", "UnexpectedImprovement(Bad)"}) {
    CHECK_FALSE(verdictNamed(word));
  }
}

}  // namespace candela::conformance
