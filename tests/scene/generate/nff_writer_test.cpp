// The text of statements, and the blocks in which it is written.
#include "host/scene/generate/nff_writer.h"

#include <array>
#include <catch2/catch.hpp>
#include <stdexcept>
#include <string>

namespace candela::generate {
namespace {

template <class Write>
std::string textOf(Write write) {
  std::string text;
  NffWriter out([&](std::string_view block) { text += block; });
  write(out);
  out.finish();
  return text;
}

}  // namespace

TEST_CASE("statements are written in the documented form with six digits") {
  CHECK(textOf([](NffWriter& out) { out.sphere({1.0 / 3, -2e6, 1e-7}, 0.5); }) == "s 0.333333 -2e+06 1e-07 0.5\n");
  CHECK(textOf([](NffWriter& out) { out.cone({0, 0, 0}, 1, {0, 0, 2}, 0.5); }) == "c 0 0 0 1 0 0 2 0.5\n");
  CHECK(textOf([](NffWriter& out) { out.light({1, 2, 3}); }) == "l 1 2 3\n");
  CHECK(textOf([](NffWriter& out) { out.box({-1, 0, 0.5}, {1, 2, 3}); }) == "box -1 0 0.5 1 2 3\n");
  CHECK(textOf([](NffWriter& out) { out.diffuse({0.1, 0.2, 0.3}); }) == "f 0.1 0.2 0.3 1 0 100000 0 1\n");
  CHECK(textOf([](NffWriter& out) { out.emitter({4, 5, 6}); }) == "f 0 0 0 1 0 0 0 0 1 0 1 4 5 6\n");
  CHECK(textOf([](NffWriter& out) { out.background({0, 0.5, 1}); }) == "b 0 0.5 1\n");
  CHECK(textOf([](NffWriter& out) {
          out.areaLight({0, 0, 3}, {1, 0, 0}, {0, -1, 0}, {7, 8, 9});
        }) == "al 0 0 3 1 0 0 0 -1 0 7 8 9\n");
  CHECK(textOf([](NffWriter& out) {
          out.polygon(std::array<glm::dvec3, 3>{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}});
        }) == "p 3\n0 0 0\n1 0 0\n0 1 0\n");
  CHECK(textOf([](NffWriter& out) { out.square(2, -1); }) == "p 4\n2 2 -1\n-2 2 -1\n-2 -2 -1\n2 -2 -1\n");
  CHECK(textOf([](NffWriter& out) {
          out.mesh(3, 1);
          for (const double x : {0.0, 1.0, 2.0}) out.meshVertex({x, 0, x * x});
          out.meshFace(1, 2, 3);
        }) == "mesh 3 1\n0 0 0\n1 0 1\n2 0 4\n1 2 3\n");
  CHECK(textOf([](NffWriter& out) {
          out.view({{1, 2, 3}, {0, 0, 0}, {0, 0, 1}, 45, 0.5, 64, 48});
        }) == "v\nfrom 1 2 3\nat 0 0 0\nup 0 0 1\nangle 45\nhither 0.5\nresolution 64 48\n");
}

TEST_CASE("nine digits preserve a number of single precision") {
  std::string text;
  NffWriter out([&](std::string_view block) { text += block; }, 9);
  out.light({1.0f / 3, 0.1f, 16777215});
  out.finish();
  CHECK(text == "l 0.333333343 0.100000001 16777215\n");
}

TEST_CASE("a highlight has half its strength at its half angle") {
  const std::string text = textOf([](NffWriter& out) { out.surface({{1, 1, 1}, 0.5, 0.5, 60, 0, 1}); });
  CHECK(text == "f 1 1 1 0.5 0.5 1 0 1\n");  // cos(60 degrees) = 1/2
  const std::string sharp = textOf([](NffWriter& out) { out.surface({{1, 1, 1}, 1, 0, 0, 0, 1}); });
  CHECK(sharp == "f 1 1 1 1 0 100000 0 1\n");
}

TEST_CASE("text is written in blocks without loss") {
  std::size_t blocks = 0;
  std::size_t largest = 0;
  std::string text;
  NffWriter out([&](std::string_view block) {
    ++blocks;
    largest = std::max(largest, block.size());
    text += block;
  });
  for (int i = 0; i < 100000; ++i) out.light({0, 0, 0});
  out.finish();
  CHECK(text.size() == 100000 * std::string("l 0 0 0\n").size());
  CHECK(blocks > 5);
  CHECK(largest < 100000);
}

TEST_CASE("exceptions of the sink are passed on") {
  NffWriter out([](std::string_view) { throw std::runtime_error("full"); });
  out.light({0, 0, 0});
  CHECK_THROWS_WITH(out.finish(), "full");
}

}  // namespace candela::generate
