// `candela bench`: selects the benchmark, and makes the checks that are common to all benchmarks.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "host/app/cli/commands.h"
#include "host/app/cli/did_you_mean.h"
#include "host/app/cli/output_check.h"

namespace candela::cli {
namespace {

struct Benchmark {
  const char* name;
  std::size_t minFileCount;  ///< after the name of the benchmark
  std::size_t maxFileCount;
  const char* complaint;  ///< message for any other number of files
  ExitCode (*run)(const BenchArguments&, const Log&);
};

constexpr std::size_t kAnyNumber = static_cast<std::size_t>(-1);
constexpr std::array kBenchmarks{
    Benchmark{"table1", 0, 0, "has its own scenes; use bench accel for others", runBenchStructures},
    Benchmark{"accel", 1, kAnyNumber, "no scene given", runBenchStructures},
    Benchmark{"rays", 1, kAnyNumber, "no scene given", runBenchRays},
    Benchmark{"error", 1, kAnyNumber, "no list of pictures given", runBenchError},
    Benchmark{"compare", 2, 2, "expected two reports, the old one and the new one", runBenchCompare}};

// A word that is neither a benchmark nor a file is regarded as a mistyped benchmark.
[[noreturn]] void refuse(const std::string& word) {
  std::vector<std::string> names;
  for (const Benchmark& benchmark : kBenchmarks) names.emplace_back(benchmark.name);
  throw UsageError(
      fmt::format("bench {}: neither a benchmark (table1, accel, rays, error, compare) nor a scene file{}\nsee candela "
                  "bench --help",
                  word, didYouMean(word, names)));
}

void requireFiles(const Benchmark& benchmark, std::size_t count) {
  if (count >= benchmark.minFileCount && count <= benchmark.maxFileCount) return;
  throw UsageError(fmt::format("bench {}: {}", benchmark.name, benchmark.complaint));
}

// Refuses options that the other benchmarks choose themselves.
void refuseOptionsOfScenes(const Benchmark& benchmark, const BenchArguments& arguments) {
  for (const char* const option : {"--sweep", "--svg", "--error", "--accel", "--bvh-split"}) {
    if (!arguments.given.contains(option)) continue;
    throw UsageError(fmt::format("bench {} {}: this option applies only to bench SCENE", benchmark.name, option));
  }
}

void requireScores(const BenchArguments& arguments) {
  if (arguments.request.image.integrator == render::Integrator::cost) {
    throw UsageError(
        "--integrator cost: the image depends on the acceleration structure, so benchmarks cannot compare it");
  }
  for (const std::string& target : {arguments.json, arguments.markdown, arguments.svg}) requireWritableReport(target);
}

}  // namespace

ExitCode run(const BenchArguments& arguments, const Log& log) {
  requireScores(arguments);
  const std::string& word = arguments.files.front();
  const auto found = std::find_if(kBenchmarks.begin(), kBenchmarks.end(),
                                  [&](const Benchmark& b) { return b.name == word; });
  const bool ofScenes = found == kBenchmarks.end();
  std::error_code ignored;
  if (ofScenes && !std::filesystem::path(word).has_extension() && !std::filesystem::exists(word, ignored)) refuse(word);
  if (ofScenes) return runBenchScenes(arguments, log);
  requireFiles(*found, arguments.files.size() - 1);
  refuseOptionsOfScenes(*found, arguments);
  return found->run(arguments, log);
}

}  // namespace candela::cli
