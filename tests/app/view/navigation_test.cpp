// Mouse and keyboard, without a window.
#include "host/app/view/navigation.h"

#include <catch2/catch.hpp>
#include <optional>

using namespace candela;
using namespace candela::view;

namespace {

constexpr render::Extent kPicture{200, 100};

struct Fixture {
  ViewState state;
  CameraControl camera{scene::Camera{}};
  Navigation navigation{state, camera};

  Fixture() {
    state.placement = {{10, 20}, 2};
    navigation.moveTo({110, 120}, kPicture);
  }
  glm::vec3 from() const { return camera.camera().from; }
  glm::vec3 at() const { return camera.camera().at; }
};

}  // namespace

TEST_CASE_METHOD(Fixture, "a left drag orbits, a right one looks around, a middle one pans") {
  const glm::vec3 start = from();
  navigation.press(Button::left, {}, kPicture);
  CHECK(navigation.moveTo({111, 120}, kPicture) == Action::none);  // still a click
  CHECK(navigation.moveTo({130, 120}, kPicture) == Action::cameraMoved);
  CHECK(from() != start);
  CHECK(at() == glm::vec3(0));
  CHECK(navigation.release(Button::left, kPicture) == Action::none);
  const glm::vec3 orbited = from();

  navigation.press(Button::right, {}, kPicture);
  CHECK(navigation.moveTo({150, 120}, kPicture) == Action::cameraMoved);
  CHECK(from() == orbited);
  CHECK(at() != glm::vec3(0));
  navigation.release(Button::right, kPicture);
  const glm::vec3 looked = at();

  navigation.press(Button::middle, {}, kPicture);
  CHECK(navigation.moveTo({160, 130}, kPicture) == Action::cameraMoved);
  CHECK(from() != orbited);
  CHECK(glm::distance(from() - orbited, at() - looked) < 1e-6f);
}

TEST_CASE_METHOD(Fixture, "a point of the picture stays below the pointer of a pan") {
  navigation.press(Button::left, {.shift = true, .control = false}, kPicture);
  navigation.moveTo({110 + 200, 120}, kPicture);                    // a height of the picture in the window
  const double height = 2 * std::tan(45 * std::numbers::pi / 360);  // of the view plane, at distance 1
  CHECK(at().x == Approx(-height));
  CHECK(at().y == 0);
}

TEST_CASE_METHOD(Fixture, "V chooses the next layer, with Shift the previous one") {
  CHECK(navigation.press(Key::v, {}) == Action::nextLayer);
  CHECK(navigation.press(Key::v, {.shift = true, .control = false}) == Action::previousLayer);
}

TEST_CASE_METHOD(Fixture, "a click inspects the pixel below the pointer") {
  navigation.press(Button::left, {}, kPicture);
  CHECK(navigation.release(Button::left, kPicture) == Action::inspect);
  CHECK(state.inspected == glm::uvec2(50, 50));
  navigation.moveTo({5, 5}, kPicture);
  navigation.press(Button::left, {}, kPicture);
  navigation.release(Button::left, kPicture);
  CHECK(!state.inspected);
}

TEST_CASE_METHOD(Fixture, "the divider moves where it is seen, and nowhere else") {
  const glm::vec3 start = from();
  navigation.moveTo({211, 120}, kPicture);  // the divider is at 10 + 2 * 100
  navigation.press(Button::left, {}, kPicture);
  navigation.moveTo({250, 120}, kPicture);
  CHECK(state.divider == 0.5);
  CHECK(from() != start);
  navigation.release(Button::left, kPicture);

  CHECK(navigation.press(Key::three, {}) == Action::modeChanged);
  CHECK(state.mode == Mode::split);
  navigation.moveTo({211, 120}, kPicture);
  const glm::vec3 before = from();
  navigation.press(Button::left, {}, kPicture);
  navigation.moveTo({310, 120}, kPicture);
  CHECK(state.divider == 0.75);
  navigation.moveTo({1000, 120}, kPicture);
  CHECK(state.divider == 1);
  CHECK(from() == before);
  CHECK(navigation.release(Button::left, kPicture) == Action::none);
}

TEST_CASE_METHOD(Fixture, "the wheel changes the distance, with Ctrl the magnification at the pointer") {
  CHECK(navigation.scroll(1, {}) == Action::cameraMoved);
  CHECK(from().z == Approx(0.9f));
  const glm::dvec2 below = state.placement.toPicture(state.pointer);
  CHECK(navigation.scroll(2, {.shift = false, .control = true}) == Action::none);
  CHECK(state.placement.zoom == Approx(2 * 1.25 * 1.25));
  CHECK(glm::distance(state.placement.toPicture(state.pointer), below) < 1e-9);
  navigation.press(Button::left, {.shift = false, .control = true}, kPicture);
  navigation.moveTo({115, 121}, kPicture);
  CHECK(glm::distance(state.placement.toPicture(state.pointer), below) < 1e-9);
}

TEST_CASE_METHOD(Fixture, "keys fly as long as they are pressed, with Shift faster") {
  CHECK(navigation.pass(1) == Action::none);
  navigation.press(Key::w, {});
  CHECK(navigation.pass(1) == Action::cameraMoved);
  CHECK(from().z == Approx(0.5f));
  CHECK(at().z == Approx(-0.5f));
  navigation.press(Key::w, {.shift = true, .control = false});
  navigation.pass(0.5);
  CHECK(from().z == Approx(-0.5f));
  navigation.release(Key::w);
  CHECK(!navigation.isFlying());
  navigation.press(Key::d, {});
  navigation.letGo();
  CHECK(navigation.pass(1) == Action::none);
}

TEST_CASE_METHOD(Fixture, "keys change exposure, tone map and gain within their ranges") {
  navigation.press(Key::bracketRight, {});
  CHECK(state.display.exposure == 0.25f);
  for (int i = 0; i < 1000; ++i) navigation.press(Key::bracketLeft, {});
  CHECK(state.display.exposure == -ViewState::kMaxExposure);
  navigation.press(Key::comma, {});
  CHECK(state.differenceStops == 0);
  navigation.press(Key::period, {});
  CHECK(state.differenceStops == 1);
  for (const auto expected : {image::ToneMap::aces, image::ToneMap::acesHill, image::ToneMap::agx,
                              image::ToneMap::neutral, image::ToneMap::none, image::ToneMap::srgb}) {
    navigation.press(Key::t, {});
    CHECK(state.display.toneMap == expected);
  }
  state.display.toneMap = image::ToneMap::depth;
  navigation.press(Key::t, {});
  CHECK(state.display.toneMap == image::ToneMap::depth);
}

TEST_CASE("pictures are placed in the middle, magnified by whole numbers alone, beside a margin") {
  CHECK(placed({100, 50}, {350, 200}).zoom == 3);
  CHECK(placed({100, 50}, {350, 200}).origin == glm::dvec2(25, 25));
  CHECK(placed({100, 50}, {50, 50}).zoom == 0.5);
  CHECK(placed({100, 50}, {300, 50}, 150).zoom == 1);
  CHECK(placed({100, 50}, {300, 50}, 150).origin == glm::dvec2(175, 0));
}

TEST_CASE("each mode requests the sides that it shows") {
  CHECK(wants(Mode::device, Side::device));
  CHECK(!wants(Mode::device, Side::reference));
  CHECK(!wants(Mode::reference, Side::device));
  CHECK(wants(Mode::reference, Side::reference));
  CHECK(wants(Mode::split, Side::device));
  CHECK(wants(Mode::difference, Side::reference));
}
