// Stores the environment and its alias table as 16-byte records.
#include <numbers>

#include "host/flatten/flatten_sections.h"

namespace candela::flatten {
namespace {

constexpr std::uint64_t kMean = scene::Environment::kMeanWeight;

struct Bin {
  std::uint32_t threshold = static_cast<std::uint32_t>(kMean);
  std::uint32_t alias = 0;
};

// The sweep of docs/light-transport.md section 6.
std::vector<Bin> aliasTable(const std::vector<std::uint64_t>& weights) {
  std::vector<Bin> bins(weights.size());
  std::vector<std::uint32_t> heavy;
  for (std::uint32_t i = 0; i < weights.size(); ++i) {
    if (weights[i] > kMean) heavy.push_back(i);
  }
  std::size_t light = 0;
  std::uint64_t left = 0;  // weight of the current heavy texel that no bin has yet
  for (std::size_t at = 0; at < heavy.size(); ++at) {
    left += weights[heavy[at]];
    for (; left > kMean; ++light) {
      while (weights[light] > kMean) ++light;
      bins[light] = {static_cast<std::uint32_t>(weights[light]), heavy[at]};
      left -= kMean - weights[light];
    }
    if (at + 1 < heavy.size()) bins[heavy[at]] = {static_cast<std::uint32_t>(left), heavy[at + 1]};
    left -= kMean;  // wraps to what the bin lacks, which the next heavy texel fills
  }
  return bins;
}

}  // namespace

Rows environmentRows(const scene::Environment& environment) {
  constexpr double kDensity = 1 / (2 * std::numbers::pi * std::numbers::pi * kMean);
  Rows rows;
  rows.reserve(environment.texels.size() + environment.texels.size() / gpu::kBinsPerRow + 1);
  for (std::size_t i = 0; i < environment.texels.size(); ++i) {
    rows.push_back(row(glm::dvec3(environment.texels[i]), kDensity * static_cast<double>(environment.weights[i])));
  }
  std::vector<Bin> bins = aliasTable(environment.weights);
  bins.resize((bins.size() + 1) / gpu::kBinsPerRow * gpu::kBinsPerRow);
  for (std::size_t i = 0; i < bins.size(); i += gpu::kBinsPerRow) {
    rows.push_back({bins[i].threshold, bins[i].alias, bins[i + 1].threshold, bins[i + 1].alias});
  }
  return rows;
}

}  // namespace candela::flatten
