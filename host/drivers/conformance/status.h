// The result of a case, in the words of deqp-runner.
#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace candela::conformance {

/// The results that a run without expectations gives come first.
enum class Status { pass, fail, skip, crash, timeout, flake, expectedFail, improvement };

/// A status with the result that an `improvement` was.
struct Verdict {
  Status status = Status::pass;
  Status improvedTo = Status::pass;

  bool operator==(const Verdict&) const = default;
  /// Returns whether deqp-runner counts it as success.
  bool isExpected() const;
};

/// Returns "Pass", "Fail", "Skip", "Crash", "Timeout", "Flake", "ExpectedFail", or "UnexpectedImprovement(Pass)" with
/// the name of the status that it was.
std::string textOf(const Verdict& verdict);
/// Reads what textOf() writes, and the words "KnownFlake", "Warn" and "Missing" of deqp-runner, which mean a
/// flake, a pass and a failure. Returns nothing for any other word.
std::optional<Verdict> verdictNamed(std::string_view word);

/// Compares a result with the one that the baseline states, as deqp-runner does.
Verdict judge(Status found, std::optional<Status> expected);

}  // namespace candela::conformance
