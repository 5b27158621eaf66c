// Devices compute the same as the reference.
#include "host/trace/denoise/device_filter.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "host/trace/denoise/reference_filter.h"
#include "tests/trace/denoise/made_films.h"
#include "tests/trace/vulkan_support/test_device.h"

using namespace candela;
using namespace candela::denoise;

namespace {

// Regions of different light, normals, albedos and noise, with misses and a pixel without samples.
PixelStatistics variedStatistics(std::uint32_t width, std::uint32_t height) {
  image::Film film = madeFilm(width, height, 5, [](std::uint32_t x, std::uint32_t y) {
    MadePixel pixel;
    pixel.radiance = glm::dvec3(0.1 + x / 5 * 0.37, 1, y / 7);
    pixel.albedo = glm::dvec3(0.2 + 0.1 * (x % 3), 0.9, 0.02 * (y % 5));
    const double angle = x / 9.0 + y / 11.0;
    pixel.normal = {std::sin(angle), 0, std::cos(angle)};
    pixel.noise = (x + y) % 4 == 0 ? 0 : 0.5;
    pixel.isHit = (x / 8 + y / 8) % 3 != 0;
    return pixel;
  });
  film.at(width / 2, height / 2) = {};
  return statisticsOf(film);
}

void requireAgreement(const PixelStatistics& statistics) {
  vulkan::Device device = openTestDevice();
  const std::vector<glm::vec3> expected = filterByReference(statistics);
  const std::vector<glm::vec3> light = filterOnDevice(device, statistics);
  REQUIRE(light.size() == expected.size());
  double largest = 0;
  for (std::size_t i = 0; i < light.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      const double error = std::abs(double{light[i][c]} - expected[i][c]) / (1 + std::abs(double{expected[i][c]}));
      largest = std::isfinite(error) ? std::max(largest, error) : 1;
    }
  }
  CHECK(largest <= kDeviceTolerance);
}

}  // namespace

TEST_CASE("a device filters like the reference, within the stated tolerance") {
  for (const auto& [width, height] : {std::pair{33u, 29u}, {1u, 1u}, {3u, 40u}, {64u, 5u}}) {
    CAPTURE(width, height);
    requireAgreement(variedStatistics(width, height));
  }
}

TEST_CASE("no division into bands and dispatches changes a bit of a device's filtered image") {
  vulkan::Device device = openTestDevice();
  const PixelStatistics statistics = variedStatistics(21, 60);
  const std::vector<glm::vec3> whole = filterOnDevice(device, statistics);
  const std::uint64_t rowBytes = 21 * (sizeof(gpu::DenoisePixel) + sizeof(glm::vec4));
  for (const std::uint64_t rows : {1u, 20u, 40u}) {
    for (const std::uint32_t pixels : {1u, 21u * 3, 1u << 16}) {
      CAPTURE(rows, pixels);
      CHECK(filterOnDevice(device, statistics, {rows * rowBytes, pixels}) == whole);
    }
  }
}

TEST_CASE("a device leaves a constant image unchanged, to the bit, and filters twice to the same bytes") {
  vulkan::Device device = openTestDevice();
  const PixelStatistics constant = statisticsOf(
      madeFilm(17, 12, 4, [](auto, auto) { return MadePixel{.radiance = glm::dvec3(0.3), .noise = 0}; }));
  const std::vector<glm::vec3> light = filterOnDevice(device, constant);
  CHECK(
      std::ranges::all_of(light, [&](const glm::vec3& value) { return value == glm::vec3(constant.pixels[0].light); }));
  const PixelStatistics varied = variedStatistics(30, 20);
  CHECK(filterOnDevice(device, varied) == filterOnDevice(device, varied));
}
