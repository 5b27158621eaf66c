// The pixels of a window: display transforms within 1/255 of those of files, the divider, and the difference.
#include "host/app/window/picture_painter.h"

#include <catch2/catch.hpp>
#include <random>

#include "tests/trace/vulkan_support/test_device.h"

using namespace candela;
using namespace candela::window;
using view::Mode;

namespace {

constexpr render::Extent kPicture{64, 48};

// Radiance over 12 decades, with greys, saturated colours, zeros and values out of range.
std::shared_ptr<view::Picture> colours() {
  auto picture = std::make_shared<view::Picture>(kPicture);
  std::mt19937 random(5);
  std::uniform_real_distribution<float> exponent(-5, 7);
  for (std::size_t i = 0; i < picture->pixels.size(); ++i) {
    const float base = std::pow(10.0f, exponent(random) / 2);
    const glm::vec3 tint = i % 3 == 0 ? glm::vec3(1)
                                      : glm::vec3(random() % 100, random() % 100, random() % 100) / 100.0f;
    picture->pixels[i] = glm::vec4(base * tint, 1);
  }
  picture->pixels[0] = {0, 0, 0, 1};
  picture->pixels[1] = {1e9f, 1e9f, 1e9f, 1};
  return picture;
}

class Canvas {
 public:
  explicit Canvas(render::Extent window) : window_(window), painter_(device_) {}

  void paint(const PaintedView& view, bool isBlueFirst = false) {
    painter_.prepare(window_, view);
    device_.run([&](vulkan::CommandRecorder& recorder) { painter_.record(recorder, view, isBlueFirst); });
    words_.resize(std::size_t{window_.width} * window_.height);
    painter_.pixels().download(std::as_writable_bytes(std::span(words_)));
  }
  glm::ivec3 at(std::uint32_t x, std::uint32_t y) const {
    const std::uint32_t word = words_[std::size_t{y} * window_.width + x];
    return {word & 255, word >> 8 & 255, word >> 16 & 255};
  }
  gpu::PointedValues pointed() const { return painter_.pointed(); }

 private:
  render::Extent window_;
  vulkan::Device device_ = openTestDevice();
  PicturePainter painter_;
  std::vector<std::uint32_t> words_;
};

PaintedView viewOf(const view::ViewState& state, Mode mode, std::shared_ptr<const view::Picture> device,
                   std::shared_ptr<const view::Picture> reference = nullptr) {
  return {.picture = kPicture,
          .pictures = {std::move(device), std::move(reference)},
          .onDevice = std::nullopt,
          .mode = mode,
          .colours = view::coloursOf({}, state.display, {}, 1),
          .isLight = true,
          .state = state};
}

std::shared_ptr<view::Picture> uniformPicture(const glm::vec4& value) {
  auto picture = std::make_shared<view::Picture>(kPicture);
  std::ranges::fill(picture->pixels, value);
  return picture;
}

int distance(const glm::ivec3& a, const glm::ivec3& b) {
  const glm::ivec3 apart = glm::abs(a - b);
  return std::max({apart.x, apart.y, apart.z});
}

}  // namespace

TEST_CASE("the window's pixels are those of files, within 1/255, with every display transform") {
  const auto picture = colours();
  Canvas canvas(kPicture);
  view::ViewState state;
  for (int toneMap = 0; toneMap <= static_cast<int>(image::ToneMap::heat); ++toneMap) {
    for (const float exposure : {-3.0f, 0.0f, 2.5f}) {
      CAPTURE(toneMap, exposure);
      state.display = {static_cast<image::ToneMap>(toneMap), exposure, 0.5f};
      canvas.paint(viewOf(state, Mode::device, picture));
      int most = 0;
      for (std::uint32_t y = 0; y < kPicture.height; ++y) {
        for (std::uint32_t x = 0; x < kPicture.width; ++x) {
          most = std::max(most,
                          distance(canvas.at(x, y), image::toDisplay(glm::vec3(picture->at(x, y)), state.display)));
        }
      }
      CHECK(most <= 1);
    }
  }
}

TEST_CASE("the colours of layers are those of files, within 1/255") {
  auto picture = uniformPicture({0, 0, 0, 1});
  std::mt19937 random(7);
  std::uniform_real_distribution<float> value(-3, 3);
  for (glm::vec4& pixel : picture->pixels) pixel = {value(random), value(random), value(random), 1};
  picture->pixels[5] = {0, 0, 0, 1};
  Canvas canvas(kPicture);
  const view::ViewState state;
  const view::LayerRange range{{-3, -2, -1}, {3, 2, 1}, 1.5f};
  for (const image::Layer layer : view::shownLayers()) {
    CAPTURE(view::shownName(layer));
    PaintedView view = viewOf(state, Mode::device, picture);
    view.colours = view::coloursOf(layer, state.display, range, 2);
    canvas.paint(view);
    int most = 0;
    for (std::uint32_t y = 0; y < kPicture.height; ++y) {
      for (std::uint32_t x = 0; x < kPicture.width; ++x) {
        most = std::max(most, distance(canvas.at(x, y), toDisplay(glm::vec3(picture->at(x, y)), view.colours)));
      }
    }
    CHECK(most <= 1);
  }
}

TEST_CASE("values that are not light are compared by the channel that differs most") {
  Canvas canvas(kPicture);
  const view::ViewState state;
  const auto paint = [&](const glm::vec3& device, const glm::vec3& reference) {
    PaintedView view = viewOf(state, Mode::difference, uniformPicture({device, 4}), uniformPicture({reference, 4}));
    view.isLight = false;
    canvas.paint(view);
    return canvas.at(9, 9);
  };
  // Their luminances are equal.
  CHECK(paint({0, 1, 0}, {0.7152f / 0.2126f, 0, 0}) == glm::ivec3(38, 128, 255));
  CHECK(paint({-0.5f, 0.5f, 0}, {-0.5f, -0.5f, 0}) == glm::ivec3(255, 140, 26));
  const glm::ivec3 equal = paint({-0.5f, 0.5f, 0}, {-0.5f, 0.5f, 0});
  CHECK(equal.x == equal.z);
}

TEST_CASE("the picture is placed and magnified, and the order of its bytes is that of the window") {
  const auto picture = colours();
  Canvas canvas({200, 120});
  view::ViewState state;
  state.placement = {{30, 10}, 2};
  canvas.paint(viewOf(state, Mode::device, picture));
  const glm::ivec3 shown = canvas.at(30 + 2 * 17 + 1, 10 + 2 * 11);
  CHECK(distance(shown, image::toDisplay(glm::vec3(picture->at(17, 11)), state.display)) <= 1);
  CHECK(canvas.at(29, 50) == canvas.at(199, 119));
  CHECK(canvas.at(29, 50) == canvas.at(30 + 2 * 64, 50));
  canvas.paint(viewOf(state, Mode::device, picture), true);
  const glm::ivec3 swapped = canvas.at(30 + 2 * 17 + 1, 10 + 2 * 11);
  CHECK(swapped == glm::ivec3(shown.z, shown.y, shown.x));
}

TEST_CASE("the device is to the left of the divider, the reference to its right") {
  const auto dark = uniformPicture({0.1f, 0.1f, 0.1f, 1}), bright = uniformPicture({0.9f, 0.9f, 0.9f, 1});
  Canvas canvas(kPicture);
  view::ViewState state;
  state.divider = 0.25;
  canvas.paint(viewOf(state, Mode::split, dark, bright));
  CHECK(distance(canvas.at(14, 20), image::toDisplay(glm::vec3(0.1f), {})) <= 1);
  CHECK(canvas.at(16, 20) == glm::ivec3(255));
  CHECK(distance(canvas.at(18, 20), image::toDisplay(glm::vec3(0.9f), {})) <= 1);
  canvas.paint(viewOf(state, Mode::reference, dark, bright));
  CHECK(distance(canvas.at(5, 20), image::toDisplay(glm::vec3(0.9f), {})) <= 1);
}

TEST_CASE(
    "the difference is orange where the device is brighter, blue where the reference is, and grows with the gain") {
  Canvas canvas(kPicture);
  view::ViewState state;
  const auto paint = [&](float device, float reference) {
    canvas.paint(viewOf(state, Mode::difference, uniformPicture({device, device, device, 4}),
                        uniformPicture({reference, reference, reference, 4})));
    return canvas.at(9, 9);
  };
  const glm::ivec3 equal = paint(0.5f, 0.5f);
  CHECK(equal.x == equal.z);
  CHECK(equal.x < 40);  // the picture, dimmed
  CHECK(paint(1, 0.1f) == glm::ivec3(255, 140, 26));
  CHECK(paint(0.1f, 1) == glm::ivec3(38, 128, 255));
  const glm::ivec3 faint = paint(0.501f, 0.5f);
  CHECK(distance(faint, equal) <= 1);
  state.differenceStops = 8;  // 0.002 * 256: half of the way
  const glm::ivec3 strong = paint(0.501f, 0.5f);
  CHECK(strong.x > 120);
  CHECK(strong.z < strong.x / 2);
}

TEST_CASE("pixels with other numbers of samples are hatched, not compared") {
  Canvas canvas(kPicture);
  const view::ViewState state;
  canvas.paint(viewOf(state, Mode::difference, uniformPicture({1, 1, 1, 4}), uniformPicture({1, 1, 1, 3})));
  CHECK(canvas.at(0, 0) == glm::ivec3(41));
  CHECK(canvas.at(4, 0) == glm::ivec3(56));
}

TEST_CASE("the values below the pointer are those of both pictures") {
  const auto picture = colours();
  Canvas canvas({200, 120});
  view::ViewState state;
  state.placement = {{30, 10}, 2};
  state.pointer = {30 + 2 * 17 + 1, 10 + 2 * 11};
  canvas.paint(viewOf(state, Mode::device, picture, uniformPicture({1, 2, 3, 4})));
  CHECK(canvas.pointed().device == picture->at(17, 11));
  CHECK(canvas.pointed().reference == glm::vec4(1, 2, 3, 4));
}
