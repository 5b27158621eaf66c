// Stores the environment, and the intervals of numbers that choose its texels, as 16-byte records.
#include <algorithm>
#include <numbers>
#include <numeric>
#include <span>

#include "host/trace/flatten/flatten_sections.h"

namespace candela::flatten {
namespace {

using Weights = std::vector<std::uint64_t>;

constexpr std::uint64_t kNumbers = std::uint64_t{1} << 32;

std::uint64_t sumOf(std::span<const std::uint64_t> weights) {
  return std::accumulate(weights.begin(), weights.end(), std::uint64_t{0});
}

// Returns the ends of the intervals of docs/light-transport.md section 6, which divide the numbers below 2^32.
Weights intervalEnds(std::span<const std::uint64_t> weights) {
  const std::uint64_t sum = sumOf(weights);
  Weights ends;
  ends.reserve(weights.size());
  std::uint64_t running = 0;
  for (const std::uint64_t weight : weights) {
    running += weight;
    const double fraction = sum > 0 ? static_cast<double>(running) / static_cast<double>(sum) : 0;
    ends.push_back(std::min(static_cast<std::uint64_t>(fraction * double{kNumbers}), kNumbers - 1));
  }
  ends.back() = kNumbers;
  return ends;
}

std::uint64_t lengthOf(const Weights& ends, std::size_t interval) {
  return ends[interval] - (interval == 0 ? 0 : ends[interval - 1]);
}

// Appends the spans of the numbers to a list of `recordCount` records, the last of `rows`.
void appendSpans(std::size_t recordCount, Rows& rows) {
  const std::size_t first = rows.size() - recordCount;
  std::vector<std::uint32_t> firstOf;  // the record with the first end above the lowest number of each part
  std::uint32_t record = 0;
  for (std::uint64_t part = 0; part < recordCount; ++part) {
    const std::uint64_t lowest = (part * kNumbers + recordCount - 1) / recordCount;
    while (record + 1 < recordCount && rows[first + record].w <= lowest) ++record;
    firstOf.push_back(record);
  }
  firstOf.resize(recordCount + 2, static_cast<std::uint32_t>(recordCount - 1));
  for (std::size_t part = 0; part < recordCount; part += gpu::kSpansPerRow) {
    rows.push_back({firstOf[part], firstOf[part + 1], firstOf[part + 1], firstOf[part + 2]});
  }
}

// The last end does not fit into a word, and is never compared.
void appendEnds(const Weights& ends, Rows& rows) {
  const auto wordAt = [&](std::size_t i) {
    return i + 1 < ends.size() ? static_cast<std::uint32_t>(ends[i]) : ~std::uint32_t{0};
  };
  for (std::size_t i = 0; i < ends.size(); i += gpu::kEndsPerRow) {
    rows.push_back({wordAt(i), wordAt(i + 1), wordAt(i + 2), wordAt(i + 3)});
  }
  appendSpans((ends.size() + gpu::kEndsPerRow - 1) / gpu::kEndsPerRow, rows);
}

Rows environmentRows(const scene::Environment& environment) {
  const std::size_t width = environment.width, height = environment.height;
  const auto weightsOfRow = [&](std::size_t y) { return std::span(environment.weights).subspan(y * width, width); };
  Weights sums;
  for (std::size_t y = 0; y < height; ++y) sums.push_back(sumOf(weightsOfRow(y)));
  const Weights rowEnds = intervalEnds(sums);
  const double area = static_cast<double>(width) * (static_cast<double>(height) - 2 * environment.offsetOfPoles());
  const double density = area / (2 * std::numbers::pi * std::numbers::pi) / double{kNumbers} / double{kNumbers};
  const auto foldOf = [&](std::size_t y) {
    return environment.hasRowsAtPoles && (y == 0 || y + 1 == height) ? 2.0 : 1.0;
  };
  Rows rows, ends;
  rows.reserve(environment.texels.size() * 3 / 2);  // the lists take 3/8 of a record per texel, and some per row
  appendEnds(rowEnds, ends);
  for (std::size_t y = 0; y < height; ++y) {
    const Weights columnEnds = intervalEnds(weightsOfRow(y));
    const double ofRow = density * foldOf(y) * static_cast<double>(lengthOf(rowEnds, y));
    for (std::size_t x = 0; x < width; ++x) {
      rows.push_back(
          row(glm::dvec3(environment.texels[y * width + x]), ofRow * static_cast<double>(lengthOf(columnEnds, x))));
    }
    appendEnds(columnEnds, ends);
  }
  rows.insert(rows.end(), ends.begin(), ends.end());
  return rows;
}

}  // namespace

void appendEnvironment(const scene::Environment& environment, FlatScene& flat) {
  flat.constants.environmentX = environment.axes[0];
  flat.constants.environmentY = environment.axes[1];
  flat.constants.environmentZ = environment.axes[2];
  flat.constants.environmentWidth = environment.width;
  flat.constants.environmentHeight = environment.height;
  flat.constants.environmentSize = {environment.width, environment.height};
  flat.constants.environmentPole = static_cast<float>(environment.offsetOfPoles());
  flat.constants.environmentRows = flat.constants.environmentSize.y - 2 * flat.constants.environmentPole;
  flat.constants.firstEnvironmentRow = rowCount(flat.rows);
  const Rows rows = environmentRows(environment);
  flat.rows.insert(flat.rows.end(), rows.begin(), rows.end());
}

}  // namespace candela::flatten
