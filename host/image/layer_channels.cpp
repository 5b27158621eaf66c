// Computes the channels of layers from the sums of a film: docs/layers.md.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "host/image/cryptomatte.h"
#include "host/image/image.h"

namespace candela::image {
namespace {

constexpr double kDepthOfNothing = 1e10;  // the distance that Blender uses

/// The sums of one pixel by their names.
class PixelSums {
 public:
  PixelSums(const Film& film, std::uint32_t x, std::uint32_t y)
      : pixel_(film.at(x, y)),
        rows_(film.layerRowsAt(x, y)),
        sums_(layerSumsOf(film.layers())),
        one_(film.radianceOfOne()) {}

  std::uint32_t hitCount() const { return rows_[0].words[0]; }
  std::uint32_t sampleCount() const { return pixel_.sampleCount; }
  const FixedSum& sum(LayerSum sum, std::size_t channel) const {
    return rows_[firstLayerRow(sums_, sum) + channel].words;
  }
  double radianceOfOne() const { return one_; }
  const FixedSum& radiance(std::size_t channel) const {
    return channel == 0 ? pixel_.red : channel == 1 ? pixel_.green : pixel_.blue;
  }

 private:
  const FilmPixel& pixel_;
  std::span<const LayerRow> rows_;
  std::uint32_t sums_;
  double one_;
};

double quotient(const FixedSum& sum, std::uint32_t count) { return count == 0 ? 0 : toSignedDouble(sum) / count; }

FixedSum difference(FixedSum a, const FixedSum& b) {
  addFixed(a, negated(b));
  return a;
}

double lightOf(const PixelSums& pixel, Layer layer, std::size_t channel) {
  FixedSum part = layer == Layer::indirect ? pixel.radiance(channel)
                  : layer == Layer::direct ? pixel.sum(LayerSum::scatteredOnce, channel)
                                           : pixel.sum(LayerSum::unscattered, channel);
  if (layer == Layer::indirect) part = difference(part, pixel.sum(LayerSum::scatteredOnce, channel));
  if (layer == Layer::direct) part = difference(part, pixel.sum(LayerSum::unscattered, channel));
  return quotient(part, pixel.sampleCount()) * pixel.radianceOfOne();
}

// The mean of the square roots of a channel, or the total variance of the albedo or of the normal of one sample.
double momentOf(const PixelSums& pixel, std::size_t channel) {
  const std::uint32_t count = pixel.sampleCount();
  if (channel < 3)
    return quotient(pixel.sum(LayerSum::rootRadiance, channel), count) * std::sqrt(pixel.radianceOfOne());
  if (count < 2) return 0;
  const LayerSum sum = channel == 3 ? LayerSum::albedo : LayerSum::normal;
  const double second = channel == 3 ? toSignedDouble(pixel.sum(LayerSum::albedoSquared, 0)) : pixel.hitCount();
  double squaredSum = 0;
  for (std::size_t i = 0; i < 3; ++i) squaredSum += std::pow(toSignedDouble(pixel.sum(sum, i)), 2);
  return std::max(0.0, second - squaredSum / count) / (count - 1);
}

double valueOf(const PixelSums& pixel, Layer layer, std::size_t channel) {
  switch (layer) {
    case Layer::normal:
      return quotient(pixel.sum(LayerSum::normal, channel), pixel.sampleCount());
    case Layer::albedo:
      return quotient(pixel.sum(LayerSum::albedo, channel), pixel.sampleCount());
    case Layer::depth:
      return pixel.hitCount() == 0 ? kDepthOfNothing : quotient(pixel.sum(LayerSum::depth, 0), pixel.hitCount());
    case Layer::position:
      return quotient(pixel.sum(LayerSum::position, channel), pixel.hitCount());
    case Layer::uv:
      return quotient(pixel.sum(LayerSum::texCoord, channel), pixel.hitCount());
    case Layer::moments:
      return momentOf(pixel, channel);
    default:
      return lightOf(pixel, layer, channel);
  }
}

std::vector<std::string> listOf(std::span<const std::string> names) { return {names.begin(), names.end()}; }

// Names of the channels of all layers, indexed by Layer.
const std::vector<std::vector<std::string>>& allChannelNames() {
  static const std::vector<std::vector<std::string>> names{
      {"N.X", "N.Y", "N.Z"},
      {"albedo.R", "albedo.G", "albedo.B"},
      {"Z"},
      {"P.X", "P.Y", "P.Z"},
      {"uv.U", "uv.V"},
      {"direct.R", "direct.G", "direct.B"},
      {"indirect.R", "indirect.G", "indirect.B"},
      {"emission.R", "emission.G", "emission.B"},
      {},
      {},
      {"sqrt.R", "sqrt.G", "sqrt.B", "variance.albedo", "variance.N"},
      listOf(cryptomatteChannelNames(MatteKind::object)),
      listOf(cryptomatteChannelNames(MatteKind::material))};
  return names;
}

// Adds all channels of a matte at once, since they use the same ranks of each pixel.
void addMatte(Image& image, const Film& film, MatteKind kind) {
  const std::size_t first = image.channels.size();
  for (const std::string& name : cryptomatteChannelNames(kind)) image.channels.push_back({name, {}});
  for (const IdCounts& counts : film.ids(kind)) {
    const CryptomatteValues values = cryptomatteValues(counts);
    for (std::size_t i = 0; i < values.size(); ++i) image.channels[first + i].values.push_back(values[i]);
  }
}

}  // namespace

std::span<const std::string> layerChannelNames(Layer layer) {
  return allChannelNames()[static_cast<std::size_t>(layer)];
}

std::vector<float> layerChannelValues(const Film& film, Layer layer, std::size_t channel) {
  std::vector<float> values;
  values.reserve(film.pixels().size());
  for (std::uint32_t y = 0; y < film.height(); ++y) {
    for (std::uint32_t x = 0; x < film.width(); ++x) {
      values.push_back(static_cast<float>(valueOf(PixelSums(film, x, y), layer, channel)));
    }
  }
  return values;
}

void addLayers(Image& image, const Film& film) {
  for (std::size_t i = 0; i < allChannelNames().size(); ++i) {
    const auto layer = static_cast<Layer>(i);
    if (!film.layers().has(layer)) continue;
    if (matteKindOf(layer)) continue;
    const std::span<const std::string> names = layerChannelNames(layer);
    for (std::size_t c = 0; c < names.size(); ++c)
      image.channels.push_back({names[c], layerChannelValues(film, layer, c)});
  }
  for (const MatteKind kind : kMatteKinds) {
    if (hasMatte(film.layers(), kind)) addMatte(image, film, kind);
  }
}

}  // namespace candela::image
