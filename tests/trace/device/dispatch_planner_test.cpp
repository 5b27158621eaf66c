// Dispatches stay short on simulated images whose regions differ in cost.
#include "host/trace/device/dispatch_planner.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <functional>
#include <set>
#include <vector>

using namespace candela;
using namespace candela::device;

namespace {

constexpr render::Extent kImage{512, 512};
constexpr double kUnitsPerSecond = 1e7;

// A render of an image whose rows have different costs, on a device that executes `kUnitsPerSecond` at a cost of 1.
class SimulatedRender {
 public:
  explicit SimulatedRender(std::function<double(std::uint32_t row)> cost)
      : cost_(std::move(cost)),
        unfinished_(kImage.width, std::vector<std::uint32_t>(kImage.height, kImage.width)),
        planner_(TileCursor(kImage, {8, 8}), {.totalPixels = kImage.width * kImage.height}, kImage.height) {}

  /// Returns the duration of the next dispatch in seconds.
  double step() {
    plan_ = planner_.next(unfinished_);
    double seconds = 1e-4;
    for (std::uint32_t y = 0; y < plan_.region.height; ++y) {
      seconds += cost_(plan_.region.y + y) * plan_.region.width * plan_.segments / kUnitsPerSecond;
    }
    planner_.record(plan_, seconds);
    return seconds;
  }
  double longestOf(int dispatches) {
    double longest = 0;
    for (int i = 0; i < dispatches; ++i) longest = std::max(longest, step());
    return longest;
  }
  const PlannedDispatch& plan() const { return plan_; }
  std::uint64_t sweeps() const { return planner_.sweeps(); }

 private:
  std::function<double(std::uint32_t)> cost_;
  UnfinishedRows unfinished_;
  DispatchPlanner planner_;
  PlannedDispatch plan_;
};

}  // namespace

TEST_CASE("an expensive region below a cheap one is dispatched within the time limit from the start") {
  // The sky covers the first part of the image; what is below costs 65 times as much.
  const std::uint32_t horizon = GENERATE(64u, 128u, 256u, 384u, 448u);
  CAPTURE(horizon);
  SimulatedRender render([horizon](std::uint32_t row) { return row < horizon ? 1.0 : 65.0; });
  CHECK(render.longestOf(1000) <= 0.25);
}

TEST_CASE("a strip in the middle of the image that costs 65 times as much stays within the limit") {
  const std::uint32_t height = GENERATE(64u, 100u, 200u);
  CAPTURE(height);
  SimulatedRender render([height](std::uint32_t row) { return row - 200u < height ? 65.0 : 1.0; });
  CHECK(render.longestOf(1000) <= 0.25);
}

TEST_CASE("the first dispatches are spread over the image, and then sweeps cover it from the top") {
  SimulatedRender render([](std::uint32_t) { return 1.0; });
  std::set<std::uint32_t> rows;
  for (int i = 0; i < 8; ++i) {
    render.step();
    rows.insert(render.plan().region.y / 64);
  }
  CHECK(rows.size() == 8);
  while (render.plan().region.y != 0 || render.plan().region.x != 0) render.step();
  CHECK(render.sweeps() == 0);
  std::uint32_t end = render.plan().region.height;
  while (end < kImage.height) {
    render.step();
    CHECK(render.plan().region.y == end);
    end += render.plan().region.height;
  }
  CHECK(render.sweeps() == 1);
}
