// The sizes of a band's buffers: bands are as high as the largest buffer permits, and no higher.
#include "host/trace/device/band_layout.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "host/base/errors.h"
#include "host/image/film.h"
#include "host/trace/flatten/flat_scene.h"
#include "tests/trace/reference/default_settings.h"

namespace candela::device {
namespace {

constexpr std::uint64_t kUnlimited = ~std::uint64_t{0};

vulkan::DeviceInfo deviceThatBinds(std::uint64_t bytes) {
  vulkan::DeviceInfo info;
  info.name = "made device";
  info.maxStorageBufferRange = bytes;
  return info;
}

std::uint64_t largestBuffer(const Kernel& kernel, const render::RenderSettings& settings, std::uint64_t pixels) {
  return std::max(
      {kernel.stateBytes * pixels, filmBytesPerPixel(settings) * pixels, resultBytes(kernel, settings, pixels)});
}

// Settings of images whose largest buffer differs: path states, the film with its layers, or the path records.
std::vector<render::RenderSettings> manySettings() {
  std::vector<render::RenderSettings> all(5, render::defaultSettings());
  for (render::RenderSettings& settings : all) settings.image.size = {300, 100000};
  all[1].execution.kernel = render::KernelKind::wavefront;
  all[2].image.layers.add(image::Layer::cryptoObject);
  all[3].execution.recordPaths = true;
  all[4].execution.recordPaths = true;
  all[4].execution.kernel = render::KernelKind::wavefront;
  return all;
}

}  // namespace

TEST_CASE("a band is as high as its largest buffer permits") {
  for (const render::RenderSettings& settings : manySettings()) {
    const Kernel kernel = kernelFor(flatten::FlatScene{}, settings);
    for (const std::uint64_t bytes : {std::uint64_t{1} << 20, std::uint64_t{3} << 26}) {
      const std::uint64_t height = bandHeight(deviceThatBinds(bytes), kernel, settings, kUnlimited);
      CHECK(bandHeight(deviceThatBinds(kUnlimited), kernel, settings, bytes) == height);
      CAPTURE(nameOf(kernel.kind), settings.execution.recordPaths, bytes, height);
      CHECK(largestBuffer(kernel, settings, 300 * height) <= bytes);
      CHECK(largestBuffer(kernel, settings, 300 * (height + 1)) > bytes);
    }
  }
}

TEST_CASE("the parts of a band's buffers follow each other") {
  render::RenderSettings settings = render::defaultSettings();
  settings.image.layers.add(image::Layer::cryptoObject);
  settings.execution.recordPaths = true;
  settings.execution.kernel = render::KernelKind::wavefront;
  const Kernel kernel = kernelFor(flatten::FlatScene{}, settings);
  CHECK(hitListOffset(settings, 10) + 10 * gpu::kListedHits * sizeof(gpu::uint) == 10 * filmBytesPerPixel(settings));
  CHECK(recordOffset(kernel, 10) + 10 * gpu::kRecordedVertices * sizeof(gpu::uvec2) ==
        resultBytes(kernel, settings, 10));
}

TEST_CASE("an image with a row that no buffer can contain is refused with the remedy") {
  render::RenderSettings settings = render::defaultSettings();
  settings.image.size = {65535, 2};
  const Kernel kernel = kernelFor(flatten::FlatScene{}, settings);
  CHECK_THROWS_WITH(bandHeight(deviceThatBinds(1 << 20), kernel, settings, kUnlimited),
                    Catch::Contains("65535 pixels wide") && Catch::Contains("made device binds at most 1024 KiB") &&
                        Catch::Contains("make it narrower"));
  CHECK(bandHeight(deviceThatBinds(kUnlimited), kernel, settings, kUnlimited) == 2);
}

}  // namespace candela::device
