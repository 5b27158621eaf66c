// Searches stage by stage, and confirms the result in a last round.
#include "host/measure/tune/search.h"

#include <algorithm>
#include <cmath>

#include "host/base/statistics/quantiles.h"

namespace candela::tune {
namespace {

constexpr double kMadToSigma = 1.4826;
constexpr double kErrorOfMedian = 1.2533;

double medianSeconds(const bench::RenderRow& row) { return statistics::median(row.measurement.traceSeconds); }

// Returns the standard error of the median, relative to the median.
double relativeError(const bench::RenderRow& row) {
  const double middle = medianSeconds(row);
  std::vector<double> deviations;
  for (const double seconds : row.measurement.traceSeconds) deviations.push_back(std::abs(seconds - middle));
  std::sort(deviations.begin(), deviations.end());
  const double runs = static_cast<double>(deviations.size());
  return middle > 0 ? kErrorOfMedian * kMadToSigma * statistics::median(deviations) / (middle * std::sqrt(runs)) : 0;
}

// Returns the indices of the dimensions of a stage.
std::vector<std::size_t> dimensionsOf(std::size_t stage) {
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < dimensionTable().size(); ++i) {
    if (dimensionTable()[i].stage == stage) numbers.push_back(i);
  }
  return numbers;
}

// Returns `start` with every combination of the values of these dimensions.
std::vector<Candidate> combinations(const Candidate& start, std::span<const std::size_t> dimensions) {
  std::vector<Candidate> all{start};
  for (const std::size_t dimension : dimensions) {
    std::vector<Candidate> more;
    for (const Candidate& one : all) {
      for (std::size_t value = 0; value < dimensionTable()[dimension].values.size(); ++value) {
        more.push_back(one);
        more.back()[dimension] = value;
      }
    }
    all = std::move(more);
  }
  return all;
}

// Returns the candidates of a stage: the built-in choice, the best one so far, and others that the device supports.
std::vector<Candidate> candidatesOf(std::span<const std::size_t> dimensions, const Candidate& best,
                                    const vulkan::DeviceInfo& info) {
  std::vector<Candidate> candidates{builtIn()};
  if (best != builtIn()) candidates.push_back(best);
  for (Candidate& candidate : combinations(best, dimensions)) {
    if (isFeasible(candidate, info) && std::ranges::find(candidates, candidate) == candidates.end()) {
      candidates.push_back(std::move(candidate));
    }
  }
  return candidates;
}

std::string purposeOf(std::span<const std::size_t> dimensions) {
  std::string purpose;
  for (const std::size_t i : dimensions) purpose += (purpose.empty() ? "" : ", ") + dimensionTable()[i].option;
  return purpose;
}

const Row& rowOf(const Round& round, const Candidate& candidate) {
  return *std::ranges::find(round.rows, candidate, &Row::candidate);
}

// Returns the best candidate after a round in which `before` took part.
Candidate bestOf(const Round& round, const Candidate& before) {
  const Row& base = rowOf(round, before);
  if (!base.agrees()) return builtIn();
  const Row* best = &base;
  for (const Row& row : round.rows) {
    if (isClearlyFaster(base, row) && gain(base, row) > gain(base, *best)) best = &row;
  }
  return best->candidate;
}

void confirm(std::uint32_t repeats, const Measure& measure, SearchResult& result) {
  const std::vector<Candidate> both{builtIn(), result.chosen};
  result.rounds.push_back({"confirmation", measure(both, 2 * repeats + 1)});
  const std::vector<Row>& rows = result.rounds.back().rows;
  if (!isClearlyFaster(rows[0], rows[1])) {
    result.chosen = builtIn();
    return;
  }
  result.chosenGain = gain(rows[0], rows[1]);
  result.chosenNoise = noise(rows[0], rows[1]);
}

// Scenes of few primitives are traced as a list, for which all layouts are the same program. Only noise would
// distinguish them.
bool hasBvh(const Row& row) {
  return std::ranges::any_of(row.scenes, [](const bench::RenderRow& scene) {
    return scene.measurement.statistics.layout != render::LayoutInUse::list;
  });
}

void dropLayouts(Round& round) {
  const auto layout = std::ranges::find(dimensionTable(), std::string("layout"), &Dimension::option);
  const auto index = static_cast<std::size_t>(layout - dimensionTable().begin());
  std::erase_if(round.rows, [&](const Row& row) { return row.candidate[index] != builtIn()[index]; });
}

}  // namespace

bool Row::agrees() const {
  return std::ranges::all_of(scenes, [](const bench::RenderRow& row) { return row.measurement.agrees; });
}

double gain(const Row& base, const Row& row) {
  if (!base.agrees() || !row.agrees()) return 0;
  double logarithms = 0;
  for (std::size_t i = 0; i < base.scenes.size(); ++i) {
    logarithms += std::log(medianSeconds(base.scenes[i]) / medianSeconds(row.scenes[i]));
  }
  return std::exp(logarithms / static_cast<double>(base.scenes.size()));
}

double noise(const Row& base, const Row& row) {
  double squares = 0;
  for (std::size_t i = 0; i < base.scenes.size(); ++i) {
    squares += std::pow(relativeError(base.scenes[i]), 2) + std::pow(relativeError(row.scenes[i]), 2);
  }
  return 2 * std::sqrt(squares) / static_cast<double>(base.scenes.size());
}

bool isClearlyFaster(const Row& base, const Row& row) {
  const double times = gain(base, row);
  return times > kMinGain && std::log(times) > noise(base, row);
}

bool SearchResult::agree() const {
  return std::ranges::all_of(rounds, [](const Round& round) { return std::ranges::all_of(round.rows, &Row::agrees); });
}

SearchResult search(const vulkan::DeviceInfo& info, std::uint32_t repeats, const Measure& measure) {
  SearchResult result;
  result.chosen = builtIn();
  for (std::size_t stage = 0; stage <= dimensionTable().back().stage; ++stage) {
    const std::vector<std::size_t> dimensions = dimensionsOf(stage);
    const std::vector<Candidate> candidates = candidatesOf(dimensions, result.chosen, info);
    result.rounds.push_back({purposeOf(dimensions), measure(candidates, repeats)});
    Round& round = result.rounds.back();
    result.tunesLayout = hasBvh(round.rows.front());
    if (!result.tunesLayout) dropLayouts(round);
    result.builtInAgrees = round.rows.front().agrees();
    if (!result.builtInAgrees) {
      result.chosen = builtIn();
      return result;
    }
    result.chosen = bestOf(round, result.chosen);
  }
  if (result.chosen != builtIn()) confirm(repeats, measure, result);
  return result;
}

}  // namespace candela::tune
