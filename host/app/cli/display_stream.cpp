// Divides images into tiles, and sends those that have changed.
#include "host/app/cli/display_stream.h"

#include <fmt/format.h>

#include <algorithm>

#include "host/app/cli/tev_packet.h"
#include "host/base/errors.h"

namespace candela::cli {
namespace {

constexpr std::uint32_t kTileSide = 64;

std::vector<std::string> channelNames(const image::Image& image) {
  std::vector<std::string> names{"R", "G", "B"};
  if (!image.alpha.empty()) names.emplace_back("A");
  for (const image::Channel& channel : image.channels) names.push_back(channel.name);
  return names;
}

std::vector<float> valuesOf(const image::Image& image) {
  std::vector<float> values;
  for (std::size_t i = 0; i < image.rgb.size(); ++i) {
    for (int channel = 0; channel < 3; ++channel) values.push_back(image.rgb[i][channel]);
    if (!image.alpha.empty()) values.push_back(image.alpha[i]);
    for (const image::Channel& channel : image.channels) values.push_back(channel.values[i]);
  }
  return values;
}

// The values of a window of an image; `stride` is the number of values in a row of the image.
std::vector<float> valuesIn(const render::Window& window, const std::vector<float>& values, std::size_t stride,
                            std::size_t channels) {
  std::vector<float> part;
  for (std::uint32_t y = window.y; y < window.y + window.height; ++y) {
    const auto first = values.begin() + static_cast<std::ptrdiff_t>(y * stride + window.x * channels);
    part.insert(part.end(), first, first + static_cast<std::ptrdiff_t>(window.width * channels));
  }
  return part;
}

std::vector<render::Window> tilesOf(const image::Image& image) {
  std::vector<render::Window> tiles;
  for (std::uint32_t y = 0; y < image.height; y += kTileSide) {
    for (std::uint32_t x = 0; x < image.width; x += kTileSide) {
      tiles.push_back({x, y, std::min(kTileSide, image.width - x), std::min(kTileSide, image.height - y)});
    }
  }
  return tiles;
}

bool sameBits(const std::vector<float>& a, const std::vector<float>& b) {
  return std::ranges::equal(std::as_bytes(std::span(a)), std::as_bytes(std::span(b)));
}

}  // namespace

DisplayStream::DisplayStream(const ServerAddress& address, std::string name, const Log& log)
    : name_(std::move(name)), log_(log) {
  try {
    server_.emplace(address);
  } catch (const FileError& error) {
    log_.warning(fmt::format("--display-server {}; the render continues without it", error.what()));
  }
}

void DisplayStream::show(const image::Image& image) {
  if (!server_) return;
  try {
    send(image);
  } catch (const FileError& error) {
    log_.warning(fmt::format("--display-server {}; the render continues without it", error.what()));
    server_.reset();
  }
}

void DisplayStream::send(const image::Image& image) {
  const std::vector<std::string> channels = channelNames(image);
  const bool isFirst = shown_.empty();
  if (isFirst) server_->send(tevCreateImage(name_, {image.width, image.height}, channels));
  std::vector<float> values = valuesOf(image);
  const std::size_t stride = image.width * channels.size();
  for (const render::Window& tile : tilesOf(image)) {
    const std::vector<float> part = valuesIn(tile, values, stride, channels.size());
    if (!isFirst && sameBits(part, valuesIn(tile, shown_, stride, channels.size()))) continue;
    server_->send(tevUpdateImage(name_, channels, tile, part));
  }
  shown_ = std::move(values);
}

}  // namespace candela::cli
