// How fast structures are built over a million primitives: medians of several builds, in processor time and by the
// clock. Not a test: machines differ. Each structure is validated before its time counts.
//   ninja bench_build && tests/bench/bench_build [threads]
#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <functional>

#include "host/accel/bvh.h"
#include "host/accel/grid.h"
#include "host/accel/primitive_bounds.h"
#include "host/core/stopwatch.h"
#include "tests/accel/inputs.h"

using namespace candela;
using namespace candela::test;

namespace {

constexpr std::size_t kPrimitives = 1'000'000;
constexpr int kRuns = 7;

// User and system time of the whole process, in seconds.
double processorSeconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
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
std::vector<Aabb> triangleSoup() {
  Random random(5);
  std::vector<Aabb> boxes(kPrimitives);
  for (Aabb& box : boxes) {
    const glm::dvec3 centre = random.inCube(0, 100);
    for (int corner = 0; corner < 3; ++corner) box.extend(glm::vec3(centre + random.inCube(0, 0.3)));
  }
  return boxes;
}

// A rough height field, row by row: a mesh as files have them.
std::vector<Aabb> triangleMesh() {
  Random random(6);
  constexpr std::size_t kSide = 707;
  std::vector<glm::vec3> points;
  for (std::size_t i = 0; i < (kSide + 1) * (kSide + 1); ++i) {
    points.emplace_back(i % (kSide + 1), i / (kSide + 1),
                        20 * std::sin(0.01 * static_cast<double>(i % (kSide + 1))) + random.real());
  }
  std::vector<Aabb> boxes;
  for (std::size_t y = 0; y < kSide; ++y) {
    for (std::size_t x = 0; x < kSide; ++x) {
      const std::size_t corner = y * (kSide + 1) + x;
      for (const std::size_t other : {corner + 1, corner + kSide + 1}) {
        Aabb& box = boxes.emplace_back();
        for (const std::size_t point : {corner, other, corner + kSide + 2}) box.extend(points[point]);
      }
    }
  }
  return boxes;
}

std::vector<Aabb> spheres() {
  Random random(7);
  std::vector<Aabb> boxes(kPrimitives);
  for (Aabb& box : boxes) box = boxAround(random.inCube(0, 100), glm::dvec3(random.real(0.05, 0.4)));
  return boxes;
}

void measure(const char* structure, const char* input, std::size_t count, const std::function<bool()>& buildAndCheck,
             const std::function<void()>& build) {
  if (!buildAndCheck()) {
    fmt::print("{:<10} {:<14} INVALID\n", structure, input);
    std::exit(1);
  }
  std::vector<double> wall, processor;
  for (int run = 0; run < kRuns; ++run) {
    const double before = processorSeconds();
    Stopwatch watch;
    build();
    wall.push_back(watch.lap());
    processor.push_back(processorSeconds() - before);
  }
  fmt::print("{:<10} {:<14} {:6.3f} s  {:6.2f} M primitives/s  (processor {:6.3f} s)\n", structure, input, median(wall),
             1e-6 * static_cast<double>(count) / median(wall), median(processor));
}

}  // namespace

int main(int argumentCount, char** arguments) {
  const auto threads = static_cast<std::uint32_t>(argumentCount > 1 ? std::atoi(arguments[1]) : 2);
  fmt::print("{} primitives, {} threads, medians of {}\n", kPrimitives, threads, kRuns);
  const std::vector<NamedInput> inputs{
      {"triangle soup", triangleSoup()}, {"triangle mesh", triangleMesh()}, {"spheres", spheres()}};
  const BvhOptions sah{.maxLeafSize = 8, .threads = threads};
  const BvhOptions midpoint{.rule = SplitRule::midpoint, .maxLeafSize = 2, .threads = threads};
  const GridOptions grid{.threads = threads};
  for (const auto& [name, boxes] : inputs) {
    const auto bvh = [&, &boxes = boxes, name = name.c_str()](const char* structure, const BvhOptions& options) {
      measure(
          structure, name, boxes.size(), [&] { return !validate(buildBvh(boxes, options), boxes, options); },
          [&] { buildBvh(boxes, options); });
    };
    bvh("sah", sah);
    bvh("midpoint", midpoint);
    measure(
        "grid", name.c_str(), boxes.size(), [&, &boxes = boxes] { return !validate(buildGrid(boxes, grid), boxes); },
        [&, &boxes = boxes] { buildGrid(boxes, grid); });
  }
}
