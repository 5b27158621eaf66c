// Resamples numbers to the texels of one image.
#include "host/formats/mitsuba/numbers.h"

#include <algorithm>
#include <cmath>

#include "host/base/errors.h"

namespace candela::mitsuba {
namespace {

bool areAlike(scene::TextureReference a, const scene::TextureReference& b) {
  a.image = b.image;
  return a == b;
}

/// The texel of an index that may be out of range: section 11 of docs/light-transport.md.
std::uint32_t wrapped(std::int64_t x, std::uint32_t count, scene::TextureWrap wrap) {
  const std::int64_t n = count;
  switch (wrap) {
    case scene::TextureWrap::repeat:
      return static_cast<std::uint32_t>((x % n + n) % n);
    case scene::TextureWrap::mirroredRepeat: {
      const std::int64_t y = (x % (2 * n) + 2 * n) % (2 * n);
      return static_cast<std::uint32_t>(std::min(y, 2 * n - 1 - y));
    }
    case scene::TextureWrap::clampToEdge:
      return static_cast<std::uint32_t>(std::clamp<std::int64_t>(x, 0, n - 1));
  }
  throw InternalError("a wrap mode without texels");
}

/// The texels around a point from 0 to 1 along an axis, and the weight of the second one.
struct Neighbours {
  std::uint32_t first, second;
  double weight;
};

Neighbours neighboursOf(double point, std::uint32_t count, scene::TextureWrap wrap, scene::TextureFilter filter) {
  if (filter == scene::TextureFilter::nearest) {
    const std::uint32_t texel = wrapped(static_cast<std::int64_t>(point * count), count, wrap);
    return {texel, texel, 0};
  }
  const double position = point * count - 0.5, first = std::floor(position);
  const auto index = static_cast<std::int64_t>(first);
  return {wrapped(index, count, wrap), wrapped(index + 1, count, wrap), position - first};
}

std::vector<double> resampled(const Numbers& source, const scene::TextureReference& use, std::uint32_t width,
                              std::uint32_t height) {
  std::vector<double> values;
  values.reserve(std::size_t{width} * height);
  for (std::uint32_t y = 0; y < height; ++y) {
    const Neighbours rows = neighboursOf((y + 0.5) / height, source.height, use.wrapT, use.filter);
    for (std::uint32_t x = 0; x < width; ++x) {
      const Neighbours columns = neighboursOf((x + 0.5) / width, source.width, use.wrapS, use.filter);
      const auto inRow = [&](std::uint32_t row) {
        const double* const texels = source.values.data() + std::size_t{row} * source.width;
        return std::lerp(texels[columns.first], texels[columns.second], columns.weight);
      };
      values.push_back(std::lerp(inRow(rows.first), inRow(rows.second), rows.weight));
    }
  }
  return values;
}

}  // namespace

bool putOnOneGrid(std::span<Numbers> numbers) {
  const auto first = std::ranges::find_if(numbers, [](const Numbers& each) { return each.use.has_value(); });
  if (first == numbers.end()) return true;
  const scene::TextureReference use = *first->use;
  bool areAllAlike = true;
  std::uint32_t width = 1, height = 1;
  for (Numbers& each : numbers) {
    if (each.use && !areAlike(*each.use, use)) {
      areAllAlike = false;
      each = {.values = {*std::ranges::max_element(each.values)}, .name = "maximum of " + each.name};
    }
    width = std::max(width, each.width);
    height = std::max(height, each.height);
  }
  for (Numbers& each : numbers) {
    if (each.values.size() > 1 && (each.width != width || each.height != height))
      each.values = resampled(each, use, width, height);
    each.width = width;
    each.height = height;
    each.use = use;
  }
  return areAllAlike;
}

std::uint64_t deepTexelOf(const glm::dvec3& colour, double alpha) {
  constexpr double kMax = 65535;
  const auto channel = [](double v) { return static_cast<std::uint64_t>(std::lround(std::clamp(v, 0.0, 1.0) * kMax)); };
  return channel(colour.x) | channel(colour.y) << 16 | channel(colour.z) << 32 | channel(alpha) << 48;
}

}  // namespace candela::mitsuba
