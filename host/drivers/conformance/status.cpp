// The rules of deqp-runner for results and expectations.
#include "host/drivers/conformance/status.h"

#include <array>
#include <utility>

namespace candela::conformance {
namespace {

constexpr std::array<std::pair<Status, std::string_view>, 7> kNames{{{Status::pass, "Pass"},
                                                                     {Status::fail, "Fail"},
                                                                     {Status::skip, "Skip"},
                                                                     {Status::crash, "Crash"},
                                                                     {Status::timeout, "Timeout"},
                                                                     {Status::flake, "Flake"},
                                                                     {Status::expectedFail, "ExpectedFail"}}};
constexpr std::array<std::pair<Status, std::string_view>, 3> kForeignNames{
    {{Status::flake, "KnownFlake"}, {Status::pass, "Warn"}, {Status::fail, "Missing"}}};
constexpr std::string_view kImprovement = "UnexpectedImprovement(";

std::string_view nameOf(Status status) {
  for (const auto& [known, name] : kNames) {
    if (known == status) return name;
  }
  return "";
}

template <class Names>
std::optional<Status> find(const Names& names, std::string_view word) {
  for (const auto& [status, name] : names) {
    if (name == word) return status;
  }
  return std::nullopt;
}

bool isBad(Status status) { return status == Status::fail || status == Status::crash || status == Status::timeout; }

}  // namespace

bool Verdict::isExpected() const { return !isBad(status) && status != Status::improvement; }

std::string textOf(const Verdict& verdict) {
  if (verdict.status != Status::improvement) return std::string(nameOf(verdict.status));
  return std::string(kImprovement) + std::string(nameOf(verdict.improvedTo)) + ")";
}

std::optional<Verdict> verdictNamed(std::string_view word) {
  if (word.starts_with(kImprovement) && word.ends_with(')')) {
    word.remove_prefix(kImprovement.size());
    word.remove_suffix(1);
    const std::optional<Status> to = find(kNames, word);
    return to ? std::optional(Verdict{Status::improvement, *to}) : std::nullopt;
  }
  std::optional<Status> status = find(kNames, word);
  if (!status) status = find(kForeignNames, word);
  return status ? std::optional(Verdict{*status}) : std::nullopt;
}

// "ExpectedFail" is in a baseline that was made from the results of a run with a baseline. It may have been any
// failure.
Verdict judge(Status found, std::optional<Status> expected) {
  if (!expected || !(isBad(*expected) || *expected == Status::expectedFail)) return {found};
  if (!isBad(found)) return {Status::improvement, found};
  const bool isSame = found == *expected || (*expected == Status::expectedFail && found != Status::timeout);
  if (isSame) return {Status::expectedFail};
  const bool wasWorse = found == Status::fail && (*expected == Status::crash || *expected == Status::timeout);
  return wasWorse ? Verdict{Status::improvement, found} : Verdict{found};
}

}  // namespace candela::conformance
