// Options of `candela conformance`.
#include <limits>

#include "host/app/cli/option_groups.h"
#include "host/app/cli/option_kinds.h"

namespace candela::cli {
namespace {

constexpr std::uint32_t kMaxJobs = 1024;

}  // namespace

// NOLINTBEGIN: each option is one row of any length.
// clang-format off
std::vector<Option> conformanceOptions() {
  constexpr OptionGroup kGroup = OptionGroup::conformance;
  return {
    list<ConformanceArguments>({"--cases", kGroup, "run the cases whose names match a pattern with *, ? and [...]; if repeated, any of the patterns"},
         "GLOB", "a pattern", [](auto& a) -> auto& { return a.cases; }),
    flag<ConformanceArguments>({"--variants", kGroup, "instead of the other cases, compare shaders with variants of them that must compute the same results"}, [](auto& a) -> auto& { return a.variants; }),
    flag<ConformanceArguments>({"--compile-only", kGroup, "compile the shaders of the cases and run none, so that the device needs neither memory nor working hardware"}, [](auto& a) -> auto& { return a.compileOnly; }),
    flag<ConformanceArguments>({"--list", kGroup, "print the names of the cases, and run none"}, [](auto& a) -> auto& { return a.list; }),
    valued<ConformanceArguments>({"--seed", kGroup, "seed of the random numbers of the cases that render pictures"},
           wholeNumber(0, std::numeric_limits<std::uint32_t>::max()), [](auto& a) -> auto& { return a.pictures.seed; }),
    valued<ConformanceArguments>({"--alpha", kGroup, "false-alarm probability of each case that renders a picture"},
           fraction("A", 1e-12, 0.5), [](auto& a) -> auto& { return a.pictures.alpha; }),
    valued<ConformanceArguments>({"--jobs", kGroup, "maximum number of child processes at a time; `auto`: one per core"},
           orAbsent(wholeNumber(1, kMaxJobs), "auto"), [](auto& a) -> auto& { return a.jobs; }),
    valued<ConformanceArguments>({"--shuffle", kGroup, "run the cases in the order that a seed determines"},
           orAbsent(wholeNumber(0, kAnySize), "off"), [](auto& a) -> auto& { return a.shuffle; }),
    valued<ConformanceArguments>({"--timeout", kGroup, "time limit of each case"},
           duration(0.1), [](auto& a) -> auto& { return a.timeout; }),
    paths<ConformanceArguments>({"--baseline", kGroup, "file of expected results, with a line `case,Result` for each case that is expected not to pass; repeatable"}, "FILE",
          [](auto& a) -> auto& { return a.baselines; }),
    paths<ConformanceArguments>({"--skips", kGroup, "file of regular expressions, one per line: cases that are not run; repeatable"}, "FILE",
          [](auto& a) -> auto& { return a.skips; }),
    paths<ConformanceArguments>({"--flakes", kGroup, "file of regular expressions, one per line: cases whose failures do not count; repeatable"}, "FILE",
          [](auto& a) -> auto& { return a.flakes; }),
    valued<ConformanceArguments>({"--csv", kGroup, "write lines `case,Result,seconds`, in the form of deqp-runner's results.csv; `-`: to stdout"},
           text("FILE", "a file, or -"), [](auto& a) -> auto& { return a.csv; }),
    path<ConformanceArguments>({"--capture", kGroup, "new folder for captures of the unexpected failures, each as `candela capture` writes it"}, "FOLDER",
         [](auto& a) -> auto& { return a.captures; }),
  };
}
// clang-format on
// NOLINTEND

}  // namespace candela::cli
