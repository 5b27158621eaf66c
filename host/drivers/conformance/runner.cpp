// Starts child processes, reads their messages, and judges their results.
#include "host/drivers/conformance/runner.h"

#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <cstdint>
#include <deque>
#include <list>
#include <map>
#include <optional>
#include <random>
#include <vector>

#include "host/base/errors.h"
#include "host/base/stopwatch.h"
#include "host/drivers/child_process.h"
#include "host/drivers/conformance/case.h"
#include "host/drivers/conformance/status.h"
#include "host/drivers/conformance/workbench.h"
#include "host/trace/vulkan/device_info.h"
#include "host/trace/vulkan/validation.h"

namespace candela::conformance {
namespace {

/// The cases of one child process, in the order in which they run.
struct Batch {
  std::vector<const Case*> cases;
  bool isSecondAttempt = false;
};

// Fisher and Yates' shuffle. std::shuffle may differ between standard libraries.
template <class Items>
void shuffleItems(Items& items, std::mt19937& random) {
  for (std::size_t left = items.size(); left > 1; --left) std::swap(items[left - 1], items[random() % left]);
}

/// Returns one batch for each group. The order of groups and of the cases within each is that of `cases`, or one that
/// the seed `shuffle` determines.
std::deque<Batch> divide(const std::vector<const Case*>& cases, std::optional<std::uint32_t> shuffle) {
  std::deque<Batch> batches;
  for (const Case* const one : cases) {
    const auto found = std::ranges::find_if(batches,
                                            [&](const Batch& b) { return b.cases.front()->group == one->group; });
    if (found == batches.end()) {
      batches.push_back({{one}});
    } else {
      found->cases.push_back(one);
    }
  }
  if (!shuffle) return batches;
  std::mt19937 random(*shuffle);
  shuffleItems(batches, random);
  for (Batch& batch : batches) shuffleItems(batch.cases, random);
  return batches;
}

/// A message of a child. The one before a case has no status.
struct ChildNote {
  std::optional<Status> status;
  std::string text;
  double seconds = 0;
};

Status statusOf(Outcome outcome) {
  if (outcome == Outcome::skip) return Status::skip;
  return outcome == Outcome::pass ? Status::pass : Status::fail;
}

ChildNote ask(const Case& question, Workbench& workbench, bool compilesOnly) {
  if (compilesOnly && !question.compile) return {Status::skip, "the case has no shader"};
  try {
    Finding finding = compilesOnly ? question.compile(workbench) : question.run(workbench);
    return {statusOf(finding.outcome), std::move(finding.text)};
  } catch (const DeviceLostError& error) {
    return {Status::crash, error.what()};
  } catch (const std::exception& error) {
    return {Status::fail, error.what()};
  }
}

void addValidation(ChildNote& note) {
  for (const std::string& message : vulkan::validationMessages()) {
    note.status = Status::fail;
    note.text += (note.text.empty() ? "" : "\n") + fmt::format("validation layer: {}", message);
  }
  vulkan::clearValidationMessages();
}

nlohmann::json toJson(const ChildNote& note) {
  nlohmann::json json{{"text", note.text}, {"seconds", note.seconds}};
  if (note.status) json["status"] = *note.status;
  return json;
}

ChildNote noteFrom(const nlohmann::json& json) {
  ChildNote note{{}, json.at("text").get<std::string>(), json.at("seconds").get<double>()};
  if (json.contains("status")) note.status = json.at("status").get<Status>();
  return note;
}

/// Runs the cases, and ends early after a device was lost, because it cannot run any more.
void runInThisProcess(const std::vector<const Case*>& cases, const vulkan::DeviceInfo& device, bool compilesOnly,
                      const process::ChildProcess::Send& send) {
  Workbench workbench(device, {.compilesOnly = compilesOnly});
  for (const Case* const question : cases) {
    send(toJson({}));
    Stopwatch watch;
    ChildNote note = ask(*question, workbench, compilesOnly);
    note.seconds = watch.lap();
    addValidation(note);
    send(toJson(note));
    if (note.status == Status::crash) return;
  }
}

using Clock = std::chrono::steady_clock;
using process::ChildProcess;

constexpr int kPollMilliseconds = 50;

double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// A child process at work on a batch.
struct Running {
  Batch batch;
  std::size_t done = 0;  ///< number of cases that have a result
  Clock::time_point since = Clock::now();
  bool tooLate = false;
  std::unique_ptr<ChildProcess> child;

  bool isComplete() const { return done == batch.cases.size(); }
};

class Runner {
 public:
  Runner(const vulkan::DeviceInfo& device, const RunOptions& options) : device_(device), options_(options) {}

  RunResult run(const Cases& cases) {
    std::vector<const Case*> chosen;
    for (const Case& one : cases) {
      if (options_.expectations.skips.match(one.name)) {
        record({one.name, {Status::skip}, "the case is listed as one to skip"});
      } else {
        chosen.push_back(&one);
      }
    }
    waiting_ = divide(chosen, options_.shuffle);
    while (!(waiting_.empty() && retries_.empty() && running_.empty()) && !isStopped()) {
      startChildren();
      listen();
      if (isStopped()) break;  // Ctrl-C has ended the children, too
      endLateChildren();
      collectEnded();
    }
    result_.interrupted = isStopped();
    result_.compilesOnly = options_.compilesOnly;
    std::ranges::sort(result_.cases, {}, &CaseResult::name);
    return std::move(result_);
  }

 private:
  bool isStopped() const { return options_.stop != nullptr && options_.stop->load(); }

  // Second attempts wait until nothing else is left, and run one at a time.
  void startChildren() {
    while (running_.size() < options_.jobs && !waiting_.empty()) startNext(waiting_);
    if (running_.empty() && !retries_.empty()) startNext(retries_);
  }

  void startNext(std::deque<Batch>& batches) {
    Running& started = running_.emplace_back();
    started.batch = std::move(batches.front());
    batches.pop_front();
    started.child = std::make_unique<ChildProcess>(options_.timeout, [&](const ChildProcess::Send& send) {
      runInThisProcess(started.batch.cases, device_, options_.compilesOnly, send);
    });
  }

  void listen() {
    std::vector<pollfd> ends;
    for (const Running& running : running_) ends.push_back({running.child->descriptor(), POLLIN, 0});
    if (::poll(ends.data(), ends.size(), kPollMilliseconds) <= 0) return;
    std::size_t i = 0;
    for (Running& running : running_) {
      if (ends[i++].revents == 0) continue;
      for (const nlohmann::json& json : running.child->receive()) take(running, noteFrom(json));
    }
  }

  void take(Running& running, const ChildNote& note) {
    running.since = Clock::now();
    if (!note.status) return;
    const Case& one = *running.batch.cases[running.done++];
    settle(running.batch, {one.name, {*note.status}, note.text, note.seconds}, one);
  }

  void endLateChildren() {
    for (Running& running : running_) {
      if (running.child->hasEnded() || Clock::now() - running.since < options_.timeout) continue;
      running.tooLate = true;
      running.child->kill();
    }
  }

  void collectEnded() {
    for (auto running = running_.begin(); running != running_.end();) {
      const bool hasEnded = running->child->hasEnded() || running->tooLate;
      if (hasEnded) settleEnd(*running);
      running = hasEnded ? running_.erase(running) : std::next(running);
    }
  }

  // If a child process is lost in a case, this case has failed. The remaining cases run again, each in a separate
  // process.
  void settleEnd(Running& running) {
    const std::string failure = running.child->failure();
    if (running.isComplete()) return;
    if (!failure.empty() || running.tooLate) {
      const Case& one = *running.batch.cases[running.done++];
      settle(running.batch, lostCase(one, running, failure), one);
    }
    for (; !running.isComplete(); ++running.done) waiting_.push_back({{running.batch.cases[running.done]}});
  }

  CaseResult lostCase(const Case& one, const Running& running, const std::string& failure) const {
    CaseResult lost{one.name, {running.tooLate ? Status::timeout : Status::crash}, "", secondsSince(running.since)};
    lost.text = running.tooLate ? fmt::format("the case does not end within {:g} s", limitSeconds())
                                : "the process of the case " + failure;
    const std::string last = running.child->lastMessage();
    if (!last.empty()) lost.text += fmt::format(", after \"{}\"", last);
    return lost;
  }

  double limitSeconds() const { return static_cast<double>(options_.timeout.count()) / 1000; }

  // `found` has the result as the child sent it.
  void settle(const Batch& batch, CaseResult found, const Case& one) {
    const Verdict verdict = judge(found.verdict.status, options_.expectations.of(one.name));
    found.verdict = verdict;
    if (batch.isSecondAttempt) return settleSecond(std::move(found));
    if (verdict.isExpected()) return record(std::move(found));
    if (options_.expectations.flakes.match(one.name))
      return recordFlake(std::move(found), "the case is listed as a flake");
    first_[one.name] = std::move(found);
    retries_.push_back({{&one}, true});
  }

  // If both results are unexpected, the second one is recorded: nothing else ran beside or before it in its process.
  void settleSecond(CaseResult second) {
    CaseResult first = std::move(first_.at(second.name));
    if (!second.verdict.isExpected()) {
      if (second.verdict != first.verdict) {
        second.text += fmt::format("\nin the first run, the result was {}", textOf(first.verdict));
      }
      return record(std::move(second));
    }
    recordFlake(std::move(first), fmt::format("when run again alone, the result was {}", textOf(second.verdict)));
  }

  void recordFlake(CaseResult found, const std::string& why) {
    found.text = fmt::format("{} ({}){}{}", textOf(found.verdict), why, found.text.empty() ? "" : ": ", found.text);
    found.verdict = {Status::flake};
    record(std::move(found));
  }

  void record(CaseResult found) {
    if (options_.note) options_.note(found);
    result_.cases.push_back(std::move(found));
  }

  const vulkan::DeviceInfo& device_;
  const RunOptions& options_;
  std::deque<Batch> waiting_;
  std::deque<Batch> retries_;  ///< second attempts
  std::list<Running> running_;
  std::map<std::string, CaseResult> first_;  ///< unexpected results of cases that run again
  RunResult result_;
};

}  // namespace

bool RunResult::isExpected() const {
  return !interrupted && std::ranges::all_of(cases, [](const CaseResult& one) { return one.verdict.isExpected(); });
}

RunResult runCases(const Cases& cases, const vulkan::DeviceInfo& device, const RunOptions& options) {
  return Runner(device, options).run(cases);
}

}  // namespace candela::conformance
