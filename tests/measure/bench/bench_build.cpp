// Measures how fast structures are built over a million primitives, in wall-clock time and in processor time of the
// busiest thread: on a machine that others use too, only the latter is that of idle cores. Medians of several builds.
// Not a test: machines differ. Each structure is validated before its time counts.
//   ninja bench_build && tests/measure/bench/bench_build [threads]
#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <functional>

#include "host/base/stopwatch.h"
#include "host/trace/accel/bvh.h"
#include "host/trace/accel/grid.h"
#include "host/trace/accel/primitive_bounds.h"
#include "tests/trace/accel/inputs.h"

using namespace candela;
using namespace candela::test;

namespace {

constexpr std::size_t kPrimitives = 1'000'000;
constexpr int kRuns = 7;

// User and system time of RUSAGE_SELF or RUSAGE_THREAD, in seconds.
double processorSeconds(int who) {
  rusage usage{};
  getrusage(who, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

// Triangles with edges of about half their distance from each other, in no order.
std::vector<accel::Aabb> triangleSoup() {
  Random random(5);
  std::vector<accel::Aabb> boxes(kPrimitives);
  for (accel::Aabb& box : boxes) {
    const glm::dvec3 centre = random.inCube(0, 100);
    for (int corner = 0; corner < 3; ++corner) box.extend(glm::vec3(centre + random.inCube(0, 0.3)));
  }
  return boxes;
}

// A rough height field, row by row: a mesh as in files.
std::vector<accel::Aabb> triangleMesh() {
  Random random(6);
  constexpr std::size_t kSide = 707;
  std::vector<glm::vec3> points;
  for (std::size_t i = 0; i < (kSide + 1) * (kSide + 1); ++i) {
    points.emplace_back(i % (kSide + 1), i / (kSide + 1),
                        20 * std::sin(0.01 * static_cast<double>(i % (kSide + 1))) + random.real());
  }
  std::vector<accel::Aabb> boxes;
  for (std::size_t y = 0; y < kSide; ++y) {
    for (std::size_t x = 0; x < kSide; ++x) {
      const std::size_t corner = y * (kSide + 1) + x;
      for (const std::size_t other : {corner + 1, corner + kSide + 1}) {
        accel::Aabb& box = boxes.emplace_back();
        for (const std::size_t point : {corner, other, corner + kSide + 2}) box.extend(points[point]);
      }
    }
  }
  return boxes;
}

std::vector<accel::Aabb> spheres() {
  Random random(7);
  std::vector<accel::Aabb> boxes(kPrimitives);
  for (accel::Aabb& box : boxes) box = boxAround(random.inCube(0, 100), glm::dvec3(random.real(0.05, 0.4)));
  return boxes;
}

struct Case {
  const char* structure;
  const std::string& input;
  std::size_t primitives;
  std::uint32_t threads;
};

void measure(const Case& of, const std::function<bool()>& isValid, const std::function<void()>& build) {
  if (!isValid()) {
    fmt::print("{} over {}: invalid\n", of.structure, of.input);
    std::exit(1);
  }
  std::vector<double> wall, busiest;
  for (int run = 0; run < kRuns; ++run) {
    const double allBefore = processorSeconds(RUSAGE_SELF), ownBefore = processorSeconds(RUSAGE_THREAD);
    Stopwatch watch;
    build();
    wall.push_back(watch.lap());
    // The calling thread works too; any other threads do the rest.
    const double own = processorSeconds(RUSAGE_THREAD) - ownBefore;
    const double others = processorSeconds(RUSAGE_SELF) - allBefore - own;
    busiest.push_back(std::max(own, others / std::max(1u, of.threads - 1)));
  }
  const auto rate = [&](double seconds) { return 1e-6 * static_cast<double>(of.primitives) / seconds; };
  const double byClock = median(wall), byThread = median(busiest);
  fmt::print("{:<10} {:<14} {:6.3f} s {:6.1f} M/s by the clock, {:6.3f} s {:6.1f} M/s by the busiest thread\n",
             of.structure, of.input, byClock, rate(byClock), byThread, rate(byThread));
}

}  // namespace

int main(int argumentCount, char** arguments) {
  const auto threads = static_cast<std::uint32_t>(argumentCount > 1 ? std::atoi(arguments[1]) : 2);
  fmt::print("{} primitives, {} threads, medians of {}\n", kPrimitives, threads, kRuns);
  const std::vector<NamedInput> inputs{
      {"triangle soup", triangleSoup()}, {"triangle mesh", triangleMesh()}, {"spheres", spheres()}};
  const accel::BvhOptions coarse{.rule = accel::SplitRule::coarseSah, .maxLeafSize = 8, .threads = threads};
  const accel::BvhOptions sah{.reinsertion = accel::Reinsertion::trunk, .maxLeafSize = 8, .threads = threads};
  const accel::BvhOptions high{.reinsertion = accel::Reinsertion::all, .maxLeafSize = 8, .threads = threads};
  const accel::BvhOptions midpoint{.rule = accel::SplitRule::midpoint, .maxLeafSize = 2, .threads = threads};
  const accel::GridOptions grid{.threads = threads};
  for (const NamedInput& input : inputs) {
    const std::vector<accel::Aabb>& boxes = input.boxes;
    const auto bvh = [&](const char* structure, const accel::BvhOptions& options) {
      measure(
          {structure, input.name, boxes.size(), threads},
          [&] { return !validate(buildBvh(boxes, options), boxes, options); }, [&] { buildBvh(boxes, options); });
    };
    bvh("sah fast", coarse);
    bvh("sah", sah);
    bvh("sah high", high);
    bvh("midpoint", midpoint);
    measure(
        {"grid", input.name, boxes.size(), threads}, [&] { return !validate(buildGrid(boxes, grid), boxes); },
        [&] { buildGrid(boxes, grid); });
  }
}
