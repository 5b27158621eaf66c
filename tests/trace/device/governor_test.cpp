// The governor limits the duration of dispatches on simulated devices: slow, fast, noisy, changing.
#include "host/trace/device/governor.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <functional>
#include <random>
#include <vector>

using namespace candela;
using namespace candela::device;

namespace {

/// Seconds for a plan of which all pixels are active. The first call also pays for compiling.
class FakeDevice {
 public:
  explicit FakeDevice(double unitsPerSecond, double overheadSeconds = 1e-4)
      : unitsPerSecond_(unitsPerSecond), overheadSeconds_(overheadSeconds) {}

  double run(const Plan& plan) {
    const double work = static_cast<double>(plan.pixels) * plan.segments / unitsPerSecond_;
    const double compile = isCompiled_ ? 0.0 : 3.0;
    isCompiled_ = true;
    return compile + overheadSeconds_ + work;
  }
  void slowDown(double factor) { unitsPerSecond_ /= factor; }

 private:
  double unitsPerSecond_;
  double overheadSeconds_;
  bool isCompiled_ = false;
};

GovernorOptions optionsFor(std::uint64_t totalPixels) {
  GovernorOptions options;
  options.totalPixels = totalPixels;
  return options;
}

/// Durations of `count` dispatches without the warm-up; `factor(i)` multiplies the i-th.
std::vector<double> drive(
    Governor& governor, FakeDevice& device, int count,
    const std::function<double(int)>& factor = [](int) { return 1.0; }) {
  std::vector<double> durations;
  for (int i = 0; i < count; ++i) {
    const Plan plan = governor.next();
    const double seconds = device.run(plan) * factor(i);
    governor.record(plan, plan.pixels, seconds);
    durations.push_back(seconds);
  }
  return durations;
}

std::vector<double> driveFromStart(
    Governor& governor, FakeDevice& device, int count,
    const std::function<double(int)>& factor = [](int) { return 1.0; }) {
  drive(governor, device, 1);
  return drive(governor, device, count, factor);
}

std::ptrdiff_t countAbove(const std::vector<double>& durations, double limit) {
  return std::count_if(durations.begin(), durations.end(), [limit](double seconds) { return seconds > limit; });
}

constexpr std::uint64_t kMegapixel = 1 << 20;

}  // namespace

TEST_CASE("the first dispatch is one workgroup and one segment, and its duration does not count") {
  Governor slowStart(optionsFor(kMegapixel)), quickStart(optionsFor(kMegapixel));
  const Plan first = slowStart.next();
  CHECK(first.pixels == 64);
  CHECK(first.segments == 1);
  slowStart.record(first, 64, 12.5);
  quickStart.record(first, 64, 1e-6);
  CHECK(slowStart.next().pixels == quickStart.next().pixels);
}

TEST_CASE("on devices of any speed dispatches come within 30 % of the target in 30 steps and never exceed the limit") {
  const double unitsPerSecond = GENERATE(1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10);
  CAPTURE(unitsPerSecond);
  Governor governor(optionsFor(4 * kMegapixel));
  FakeDevice device(unitsPerSecond);
  const std::vector<double> durations = driveFromStart(governor, device, 60);
  CHECK(countAbove(durations, 0.25) == 0);
  for (std::size_t i = 30; i < durations.size(); ++i) CHECK(durations[i] == Approx(0.1).epsilon(0.3));
}

TEST_CASE("a device that becomes five times slower exceeds the time limit at most once") {
  for (const double unitsPerSecond : {1e6, 1e8}) {
    Governor governor(optionsFor(kMegapixel));
    FakeDevice device(unitsPerSecond);
    driveFromStart(governor, device, 40);
    device.slowDown(5);
    const std::vector<double> durations = drive(governor, device, 100);
    CHECK(countAbove(durations, 0.25) <= 1);
    CHECK(durations[1] <= 0.13);
    CHECK(durations.back() <= 0.13);
    CHECK(durations.back() >= 0.04);  // the governor lowers its target for some time
  }
}

TEST_CASE("a device that becomes a hundred times faster is used fully again after some seconds of work") {
  Governor governor(optionsFor(kMegapixel));
  FakeDevice device(1e6);
  driveFromStart(governor, device, 40);
  device.slowDown(0.01);
  double total = 0;
  while (total < 6) total += drive(governor, device, 1).front();
  CHECK(drive(governor, device, 1).back() == Approx(0.1).epsilon(0.3));
}

TEST_CASE("durations that vary by a factor of two up and down stay within the limit at the 99th percentile") {
  Governor governor(optionsFor(kMegapixel));
  FakeDevice device(1e7);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> exponent(-1.0, 1.0);
  const auto noise = [&](int) { return std::exp2(exponent(random)); };
  const std::vector<double> durations = driveFromStart(governor, device, 1000, noise);
  CHECK(countAbove(durations, 0.25) <= 10);
  double sum = 0;
  for (const double seconds : durations) sum += seconds;
  CHECK(sum / 1000 > 0.03);  // and dispatches do not stay short without need
}

TEST_CASE("a sweep whose strips differ in cost by a factor of eight stays within the limit at the 99th percentile") {
  Governor governor(optionsFor(kMegapixel));
  FakeDevice device(1e7);
  const auto cost = [](int i) { return i % 20 < 15 ? 1.0 : 8.0; };  // sky, then glass
  const std::vector<double> durations = driveFromStart(governor, device, 1000, cost);
  CHECK(countAbove(durations, 0.25) <= 10);
}

TEST_CASE("while the governor probes, dispatches take 1/32 of the target") {
  Governor governor(optionsFor(4 * kMegapixel));
  FakeDevice device(1e7);
  drive(governor, device, 1);
  int probes = 0;
  for (; governor.isProbing(); ++probes) CHECK(drive(governor, device, 1).front() <= 0.1 / 32 * 1.1);
  CHECK(probes >= 8);
  CHECK(probes < 32);
}

TEST_CASE("dispatches that stay short end the probing") {
  Governor governor(optionsFor(6));
  FakeDevice device(1e9);
  drive(governor, device, 1);
  drive(governor, device, 31);
  CHECK(governor.isProbing());
  drive(governor, device, 1);
  CHECK_FALSE(governor.isProbing());
}

TEST_CASE("a cheap region does not decide how much work an expensive one gets, once it was dispatched") {
  Governor governor(optionsFor(kMegapixel));
  FakeDevice device(1e7);
  const auto cost = [](int i) { return i % 20 < 15 ? 1.0 : 65.0; };
  driveFromStart(governor, device, 40, cost);
  const std::vector<double> durations = drive(governor, device, 400, cost);
  CHECK(countAbove(durations, 0.25) == 0);
}

TEST_CASE("the region shrinks if one segment of the whole image takes seconds") {
  Governor governor(optionsFor(kMegapixel));
  FakeDevice device(1e5);  // one segment of the image: 10 s; of 16384 pixels: 0.16 s
  driveFromStart(governor, device, 30);
  const Plan plan = governor.next();
  CHECK(plan.segments == 1);
  CHECK(plan.pixels < 16384);
  CHECK(plan.pixels % 64 == 0);
}

TEST_CASE(
    "paths get 128 segments before more pixels are used than the device needs, and more once all pixels are used") {
  const auto planAt = [](double unitsPerSecond) {
    Governor governor(optionsFor(kMegapixel));
    FakeDevice device(unitsPerSecond, 0.0);
    driveFromStart(governor, device, 60);
    return governor.next();
  };
  const Plan few = planAt(1e6);  // 1e5 units: 16384 pixels of 6
  CHECK(few.segments == 6);
  CHECK(few.pixels == 16640);       // 1e5 / 6, whole workgroups of 64
  const Plan middle = planAt(4e7);  // 4e6 units
  CHECK(middle.segments == 128);
  CHECK(middle.pixels == Approx(31250).epsilon(0.01));
  const Plan all = planAt(5e9);  // 5e8 units
  CHECK(all.pixels == kMegapixel);
  CHECK(all.segments == 476);
  CHECK(planAt(1e12).segments == 1024);
}

TEST_CASE("work grows at most eightfold from one dispatch to the next, and twofold near the target") {
  Governor governor(optionsFor(kMegapixel));
  FakeDevice device(1e7);
  double units = 64;
  double seconds = 0;
  drive(governor, device, 1);
  for (int i = 0; i < 30; ++i) {
    const Plan plan = governor.next();
    const double now = static_cast<double>(plan.pixels) * plan.segments;
    CHECK(now <= units * (seconds > 0.1 / 8 ? 2.01 : 8.05));  // both are rounded to whole segments and workgroups
    units = now;
    seconds = device.run(plan);
    governor.record(plan, plan.pixels, seconds);
  }
}

TEST_CASE("the maximum number of segments is respected by using more pixels") {
  GovernorOptions options = optionsFor(kMegapixel);
  options.maxSegments = 4;
  Governor governor(options);
  FakeDevice device(1e7);
  const std::vector<double> durations = driveFromStart(governor, device, 40);
  CHECK(governor.next().segments == 4);
  CHECK(governor.next().pixels == Approx(250000).epsilon(0.05));
  CHECK(durations.back() == Approx(0.1).epsilon(0.3));
}

TEST_CASE("an image smaller than a workgroup is dispatched whole") {
  Governor governor(optionsFor(6));
  CHECK(governor.next().pixels == 6);
  FakeDevice device(1e9);
  driveFromStart(governor, device, 20);
  CHECK(governor.next().pixels == 6);
  CHECK(governor.next().segments == 1024);
}

TEST_CASE("a fixed number of segments is used, and the number of pixels adapts") {
  GovernorOptions options = optionsFor(kMegapixel);
  options.fixedSegments = 100;
  Governor governor(options);
  CHECK(governor.next().segments == 100);
  FakeDevice device(1e7);
  const std::vector<double> durations = driveFromStart(governor, device, 40);
  CHECK(governor.next().segments == 100);
  CHECK(governor.next().pixels == Approx(10000).epsilon(0.02));
  CHECK(governor.segmentsFor(1) == 100);
  CHECK(durations.back() == Approx(0.1).epsilon(0.3));
}

TEST_CASE("a fixed region is used, and the number of segments adapts") {
  GovernorOptions options = optionsFor(kMegapixel);
  options.fixedPixels = 1000;
  Governor governor(options);
  CHECK(governor.next().pixels == 1000);
  FakeDevice device(1e6);
  driveFromStart(governor, device, 40);
  CHECK(governor.next().pixels == 1000);
  CHECK(governor.next().segments == Approx(100).epsilon(0.05));
  options.fixedSegments = 7;
  Governor fixed(options);
  driveFromStart(fixed, device, 40);
  CHECK(fixed.next().pixels == 1000);
  CHECK(fixed.next().segments == 7);
}

TEST_CASE("if few pixels have work left, they get more segments") {
  Governor governor(optionsFor(kMegapixel));
  FakeDevice device(1e8, 0.0);
  driveFromStart(governor, device, 60);
  CHECK(governor.segmentsFor(kMegapixel) == 9);
  CHECK(governor.segmentsFor(100000) == Approx(100).epsilon(0.02));
  CHECK(governor.segmentsFor(0) == 1024);
}

TEST_CASE("a short dispatch of a small remainder does not reduce the next ones") {
  Governor governor(optionsFor(kMegapixel));
  FakeDevice device(1e8);
  driveFromStart(governor, device, 60);
  const Plan before = governor.next();
  governor.record({64, before.segments}, 64, 2e-3);
  CHECK(governor.next().pixels == before.pixels);
  CHECK(governor.next().segments == before.segments);
}
