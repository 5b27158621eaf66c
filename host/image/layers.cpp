// The arithmetic of layers: which sums they need, and how samples are added.
#include "host/image/layers.h"

#include <algorithm>
#include <cmath>

#include "host/image/fixed_sum.h"

namespace candela::image {
namespace {

constexpr std::array<std::string_view, 13> kLayerNames{
    "normal",  "albedo",  "depth",         "position",       "uv", "direct", "indirect", "emission", "variance",
    "samples", "moments", "crypto-object", "crypto-material"};

struct SumSpan {
  LayerSum sum;
  std::string_view name;
  std::uint32_t count;
};
constexpr std::array kSums{
#define CANDELA_LIST_SUM(sum, has, row, bit, count) SumSpan{LayerSum::sum, #sum, count},
    CANDELA_LAYER_SUMS(CANDELA_LIST_SUM)
#undef CANDELA_LIST_SUM
};

constexpr std::uint32_t bitOf(LayerSum sum) { return static_cast<std::uint32_t>(sum); }

// Letters of a sum's channels.
std::string_view lettersOf(LayerSum sum) {
  switch (sum) {
    case LayerSum::normal:
    case LayerSum::position:
      return "XYZ";
    case LayerSum::depth:
      return "Z";
    case LayerSum::albedoSquared:
      return "Y";
    case LayerSum::texCoord:
      return "UV";
    default:
      return "RGB";
  }
}

std::uint32_t sumsOf(Layer layer) {
  switch (layer) {
    case Layer::normal:
      return bitOf(LayerSum::normal);
    case Layer::albedo:
      return bitOf(LayerSum::albedo);
    case Layer::depth:
      return bitOf(LayerSum::depth);
    case Layer::position:
      return bitOf(LayerSum::position);
    case Layer::uv:
      return bitOf(LayerSum::texCoord);
    case Layer::direct:
      return bitOf(LayerSum::unscattered) | bitOf(LayerSum::scatteredOnce);
    case Layer::indirect:
      return bitOf(LayerSum::scatteredOnce);
    case Layer::emission:
      return bitOf(LayerSum::unscattered);
    case Layer::moments:
      return bitOf(LayerSum::normal) | bitOf(LayerSum::albedo) | bitOf(LayerSum::rootRadiance) |
             bitOf(LayerSum::albedoSquared);
    case Layer::variance:
    case Layer::samples:
    case Layer::cryptoObject:
    case Layer::cryptoMaterial:
      break;
  }
  return 0;
}

// Truncates a value towards 0 and limits it to the range of the film. Sets `bad` if the limit changes it.
FixedSum toSignedFixed(double value, bool& bad) {
  if (!std::isfinite(value)) {
    bad = true;
    return {};
  }
  bad = bad || std::abs(value) > kFilmMaximum;
  const FixedSum magnitude = toFixed(std::min(std::abs(value), kFilmMaximum));
  return value < 0 ? negated(magnitude) : magnitude;
}

// Returns the value that the film adds for a channel of a sample.
double keptOf(double whole) { return std::isfinite(whole) && whole >= 0 ? std::min(whole, kFilmMaximum) : 0; }

// Returns a part of the radiance, limited to the value that the film adds for the whole.
double partOf(double whole, double part) {
  const double kept = keptOf(whole);
  return part >= 0 ? std::min(part, kept) : 0;  // 0 also where it is not a number
}

/// Adds the channels of a sample to those sums of a pixel that it has.
class SampleAdder {
 public:
  SampleAdder(std::span<LayerRow> rows, std::uint32_t sums) : rows_(rows), sums_(sums) {}

  template <class Vector>
  void add(LayerSum sum, const Vector& value) {
    if ((sums_ & bitOf(sum)) == 0) return;
    const std::uint32_t first = firstLayerRow(sums_, sum);
    for (int i = 0; i < Vector::length(); ++i) {
      addFixed(rows_[first + static_cast<std::uint32_t>(i)].words, toSignedFixed(value[i], bad_));
    }
  }
  bool foundBad() const { return bad_; }

 private:
  std::span<LayerRow> rows_;
  std::uint32_t sums_;
  bool bad_ = false;
};

glm::dvec3 partOf(const glm::dvec3& whole, const glm::dvec3& part) {
  return {partOf(whole.x, part.x), partOf(whole.y, part.y), partOf(whole.z, part.z)};
}

}  // namespace

std::span<const std::string_view> layerNames() { return kLayerNames; }

LayerSet withSums(LayerSet layers) {
  LayerSet kept;
  for (std::uint32_t i = 0; i < kLayerNames.size(); ++i) {
    const auto layer = static_cast<Layer>(i);
    if (layers.has(layer) && layer != Layer::variance && layer != Layer::samples) kept.add(layer);
  }
  return kept;
}

bool hasMatte(LayerSet layers, MatteKind kind) {
  return layers.has(kind == MatteKind::object ? Layer::cryptoObject : Layer::cryptoMaterial);
}

std::optional<MatteKind> matteKindOf(Layer layer) {
  if (layer == Layer::cryptoObject) return MatteKind::object;
  if (layer == Layer::cryptoMaterial) return MatteKind::material;
  return std::nullopt;
}

bool hasMattes(LayerSet layers) {
  return std::ranges::any_of(kMatteKinds, [&](MatteKind kind) { return hasMatte(layers, kind); });
}

std::string layerText(LayerSet layers) {
  std::string text;
  for (std::size_t i = 0; i < kLayerNames.size(); ++i) {
    if (!layers.has(static_cast<Layer>(i))) continue;
    text += text.empty() ? "" : ",";
    text += kLayerNames[i];
  }
  return text.empty() ? "none" : text;
}

std::uint32_t layerSumsOf(LayerSet layers) {
  std::uint32_t sums = 0;
  for (std::uint32_t i = 0; i < kLayerNames.size(); ++i) {
    if (layers.has(static_cast<Layer>(i))) sums |= sumsOf(static_cast<Layer>(i));
  }
  return sums;
}

std::uint32_t layerRowCount(std::uint32_t sums) {
  std::uint32_t count = sums == 0 ? 0 : 1;
  for (const SumSpan& entry : kSums) count += (sums & bitOf(entry.sum)) != 0 ? entry.count : 0;
  return count;
}

std::uint32_t firstLayerRow(std::uint32_t sums, LayerSum sum) {
  const std::uint32_t before = sums & (bitOf(sum) - 1);
  return std::max(layerRowCount(before), 1u);
}

std::vector<std::string> layerSumNames(std::uint32_t sums) {
  std::vector<std::string> names;
  for (const SumSpan& entry : kSums) {
    if ((sums & bitOf(entry.sum)) == 0) continue;
    for (const char letter : lettersOf(entry.sum).substr(0, entry.count)) {
      names.push_back(std::string(entry.name) + '.' + letter);
    }
  }
  return names;
}

void addLayerRows(std::span<LayerRow> sums, std::span<const LayerRow> terms) {
  if (sums.empty()) return;
  for (std::size_t i = 0; i < 3; ++i) sums[0].words[i] += terms[0].words[i];
  for (std::size_t row = 1; row < sums.size(); ++row) addFixed(sums[row].words, terms[row].words);
}

void addLayerSample(std::span<LayerRow> rows, std::uint32_t sums, const LayerSample& sample,
                    const glm::dvec3& radiance) {
  SampleAdder adder(rows, sums);
  if (sample.hit) {
    adder.add(LayerSum::normal, sample.hit->normal);
    adder.add(LayerSum::albedo, sample.hit->albedo);
    adder.add(LayerSum::depth, glm::dvec1(sample.hit->depth));
    adder.add(LayerSum::position, sample.hit->position);
    adder.add(LayerSum::texCoord, sample.hit->texCoord);
    adder.add(LayerSum::albedoSquared, glm::dvec1(dot(sample.hit->albedo, sample.hit->albedo)));
  }
  adder.add(LayerSum::unscattered, partOf(radiance, sample.unscattered.value_or(radiance)));
  adder.add(LayerSum::scatteredOnce, partOf(radiance, sample.scatteredOnce.value_or(radiance)));
  adder.add(LayerSum::rootRadiance, sqrt(glm::dvec3(keptOf(radiance.x), keptOf(radiance.y), keptOf(radiance.z))));
  rows[0].words[0] += sample.hit ? 1 : 0;
  rows[0].words[1] += adder.foundBad() ? 1 : 0;
}

}  // namespace candela::image
