// The order of the steps of a viewer.
#include "host/app/view/schedule.h"

#include <catch2/catch.hpp>

using namespace candela::view;

namespace {

constexpr candela::render::Extent kImage{640, 360};
constexpr double kPixels = 640.0 * 360.0;

// Finishes the next step as if a sample of a pixel took `seconds`.
Step finishNext(Schedule& schedule, double seconds) {
  const Step step = schedule.next().value();
  const auto size = scaled(kImage, step.scale);
  const std::uint32_t before = step.scale == 1 ? schedule.samples(step.side) : 0;
  schedule.finish(step, seconds * size.width * size.height * (step.sampleEnd - before));
  return step;
}

}  // namespace

TEST_CASE("nothing is rendered unless a side is requested") {
  Schedule schedule(kImage, 4);
  CHECK(!schedule.next());
  schedule.setWanted(Side::reference, true);
  CHECK(schedule.next()->side == Side::reference);
}

TEST_CASE("pictures become finer, and samples then double up to the last one") {
  Schedule schedule(kImage, 11);
  schedule.setWanted(Side::device, true);
  std::vector<Step> steps;
  while (schedule.next()) steps.push_back(finishNext(schedule, 1e-9));
  const std::vector<Step> expected{{Side::device, 8, 1}, {Side::device, 4, 1}, {Side::device, 2, 1},
                                   {Side::device, 1, 1}, {Side::device, 1, 2}, {Side::device, 1, 4},
                                   {Side::device, 1, 8}, {Side::device, 1, 11}};
  CHECK(steps == expected);
}

TEST_CASE("the first picture of a view takes at most the time of a preview, by the speed measured before") {
  Schedule schedule(kImage, 100);
  schedule.setWanted(Side::device, true);
  const double fast = Schedule::kPreviewSeconds / kPixels;
  for (const auto& [seconds, scale] :
       {std::pair{0.9 * fast, 1u}, {3.9 * fast, 2u}, {15.9 * fast, 4u}, {1e6 * fast, kMaxScale}}) {
    finishNext(schedule, seconds);
    schedule.restart();
    CHECK(schedule.next()->scale == scale);
    CHECK(schedule.samples(Side::device) == 0);
  }
}

TEST_CASE("steps take about the time of a step, but trace one sample at least") {
  Schedule schedule(kImage, 1000000);
  schedule.setWanted(Side::device, true);
  for (int i = 0; i < 40; ++i) finishNext(schedule, 0.01 / kPixels);
  const std::uint32_t before = schedule.samples(Side::device);
  CHECK(schedule.next()->sampleEnd == before + 10);
  finishNext(schedule, 5 / kPixels);
  CHECK(schedule.next()->sampleEnd == before + 11);
}

TEST_CASE("two sides alternate, and stop at equal numbers of samples") {
  Schedule schedule(kImage, 64);
  schedule.setWanted(Side::device, true);
  schedule.setWanted(Side::reference, true);
  std::uint32_t levels = 0;
  while (const auto step = schedule.next()) {
    finishNext(schedule, step->side == Side::device ? 1e-9 : 1e-6);
    if (!schedule.isLevel()) continue;
    ++levels;
    CHECK(schedule.samples(Side::device) == schedule.samples(Side::reference));
  }
  CHECK(levels > 6);
  CHECK(schedule.samples(Side::reference) == 64);
}

TEST_CASE("while the view moves, no side starves") {
  Schedule schedule(kImage, 64);
  schedule.setWanted(Side::device, true);
  schedule.setWanted(Side::reference, true);
  std::array<int, kSideCount> pictures{};
  for (int i = 0; i < 10; ++i) {
    ++pictures[indexOf(finishNext(schedule, 1e-7).side)];
    schedule.restart();
  }
  CHECK(pictures == std::array{5, 5});
}
