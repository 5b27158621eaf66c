// Derives tolerances from replicas of the reference's sample.
#include "host/drivers/capture/sample_values.h"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "host/drivers/capture/replay.h"
#include "host/judge/verify/decisions.h"

namespace candela::capture {
namespace {

constexpr std::uint32_t kReplicas = 16;
constexpr std::uint32_t kPixelWords = sizeof(image::FilmPixel) / sizeof(std::uint32_t);
constexpr std::uint32_t kSumWords = 4;  // a sum and the count after it

/// The radiance of a sample, and the maximum difference of a device in each channel.
struct Radiance {
  glm::dvec3 mean{0};
  double tolerance = 0;
};

/// Returns nothing if replicas take different decisions.
std::optional<Radiance> radianceOf(const render::PixelSample& sample, render::ReplicaSource& reference,
                                   double quantum) {
  std::vector<render::Replica> replicas;
  for (std::uint32_t i = 0; i < kReplicas; ++i) replicas.push_back(reference.replica(sample, i));
  Radiance radiance;
  for (const render::Replica& replica : replicas) {
    if (replica.vertex != 0) return std::nullopt;
    radiance.mean += replica.radiance / double{kReplicas};
  }
  double spread = 0, largest = 0;
  for (const render::Replica& replica : replicas) {
    for (int k = 0; k < 3; ++k) spread = std::max(spread, std::abs(replica.radiance[k] - radiance.mean[k]));
  }
  for (int k = 0; k < 3; ++k) largest = std::max(largest, std::abs(radiance.mean[k]));
  radiance.tolerance = verify::kSpread * spread + verify::kSpreadFloor * largest + quantum;
  return radiance;
}

// `one` is the radiance that is 1 in the sums.
void expectPixel(std::uint32_t pixel, const Radiance& radiance, double one, const image::FilmPixel& exact,
                 ExpectedValues& expected) {
  const std::uint32_t first = kPixelWords * pixel;
  for (std::uint32_t k = 0; k < 3; ++k) {
    const double mean = radiance.mean[static_cast<int>(k)];
    expected.push_back({ValueType::sum,
                        {kFilmBinding, first + kSumWords * k},
                        (mean - radiance.tolerance) / one,
                        (mean + radiance.tolerance) / one});
  }
  const std::array counts{exact.sampleCount, exact.badCount};
  for (std::uint32_t k = 0; k < counts.size(); ++k) {
    const double count = counts[k];
    expected.push_back({ValueType::word, {kFilmBinding, first + kSumWords * k + 3}, count, count});
  }
}

std::span<const std::uint32_t> wordsOf(const image::Film& film) {
  const auto& pixels = film.pixels();
  return {reinterpret_cast<const std::uint32_t*>(pixels.data()), pixels.size() * kPixelWords};
}

}  // namespace

ExpectedValues expectedFilm(const scene::Scene& scene, const render::RenderSettings& settings, std::uint32_t index,
                            render::Renderer& reference) {
  render::RenderSettings replicated = settings;
  replicated.execution.replicas = kReplicas;
  const std::unique_ptr<render::Session> session = reference.prepare(scene, replicated);
  session->advance({index, index + 1}, {});
  const image::Film film = session->film();
  const render::Window window = settings.image.window();
  ExpectedValues expected;
  for (std::uint32_t pixel = 0; pixel < window.width * window.height; ++pixel) {
    const std::uint32_t x = pixel % window.width, y = pixel / window.width;
    const image::FilmPixel& exact = film.at(x, y);
    const std::optional<Radiance> radiance = radianceOf({window.x + x, window.y + y, index}, *session->replicaSource(),
                                                        verify::filmQuantum(film));
    if (radiance && exact.badCount == 0) expectPixel(pixel, *radiance, film.radianceOfOne(), exact, expected);
  }
  return expected;
}

ExpectedValues bitsOf(const image::Film& film) {
  ExpectedValues expected;
  const std::span words = wordsOf(film);
  for (std::uint32_t i = 0; i < words.size(); ++i) {
    const double word = words[i];
    expected.push_back({ValueType::word, {kFilmBinding, i}, word, word});
  }
  return expected;
}

std::size_t differingCount(const image::Film& film, const ExpectedValues& expected) {
  const std::span words = wordsOf(film);
  return static_cast<std::size_t>(std::ranges::count_if(expected, [&](const ExpectedValue& value) {
    const double found = valueOf(value.type, words.subspan(value.position.word));
    return !(found >= value.low && found <= value.high);
  }));
}

}  // namespace candela::capture
