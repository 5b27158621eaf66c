// The order in which rays are traced, the comparison of their hits, and the figures that a report omits.
#include "host/measure/bench/measure_rays.h"

#include <atomic>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <optional>

#include "host/measure/bench/ray_report.h"

namespace candela::bench {
namespace {

using Catch::Contains;

constexpr std::uint32_t kDistanceBits = 0x40000000;

// Derives the hit of each ray from its index, except for one that is wrong.
class FakeTracer : public RayTracer {
 public:
  FakeTracer(std::string name, std::vector<std::string>& log, std::optional<std::size_t> wrong = {}, bool exact = true)
      : name_(std::move(name)), log_(log), wrong_(wrong), exact_(exact) {}

  void load(std::span<const gpu::CastRay> rays, bool anyHit) override {
    count_ = rays.size();
    anyHit_ = anyHit;
  }
  double trace() override {
    log_.push_back(name_ + (anyHit_ ? " any" : ""));
    return static_cast<double>(++traces_);
  }
  std::vector<gpu::CastHit> hits() override {
    std::vector<gpu::CastHit> result(count_);
    for (std::uint32_t i = 0; i < count_; ++i) result[i].found = {exact_ ? kDistanceBits : kDistanceBits + 1, i, 10, 0};
    if (wrong_) result[*wrong_].found.y = 1000;
    return result;
  }
  bool isExact() const override { return exact_; }
  bool needsWarmUp() const override { return onGpu; }

  bool onGpu = false;

 private:
  std::string name_;
  std::vector<std::string>& log_;
  std::optional<std::size_t> wrong_;
  bool exact_;
  std::size_t count_ = 0;
  bool anyHit_ = false;
  int traces_ = 0;
};

device::RaySets setsOf(std::size_t primary, std::size_t shadow) {
  device::RaySets sets;
  sets[gpu::kPrimaryRay].resize(primary);
  sets[gpu::kShadowRay].resize(shadow);
  return sets;
}

TEST_CASE("for each kind of rays, every tracer warms up, and all run once before any runs twice") {
  std::vector<std::string> log;
  FakeTracer a("a", log), b("b", log);
  RayTracer* const tracers[]{&a, &b};
  const auto measurements = measureRays(tracers, setsOf(4, 2), 2, nullptr);
  CHECK(log ==
        std::vector<std::string>{"a", "b", "a", "b", "a", "b", "a any", "b any", "a any", "b any", "a any", "b any"});
  REQUIRE(measurements.size() == 4);
  CHECK(measurements[0].seconds == std::vector<double>{2, 3});
  CHECK(measurements[0].rayCount == 4);
  CHECK(measurements[0].mraysPerSecond() == Approx(4e-6 / 2.5));
  CHECK(measurements[0].stepsPerRay == 10);
  CHECK(measurements[3].kind == gpu::kShadowRay);
  CHECK(measurements[3].rayCount == 2);
}

TEST_CASE("a tracer on a GPU traces rays untimed before every timed run") {
  std::vector<std::string> log;
  FakeTracer a("a", log), gpu("gpu", log);
  gpu.onGpu = true;
  RayTracer* const tracers[]{&a, &gpu};
  const auto measurements = measureRays(tracers, setsOf(4, 0), 2, nullptr);
  CHECK(log == std::vector<std::string>{"a", "gpu", "a", "gpu", "gpu", "a", "gpu", "gpu"});
  REQUIRE(measurements.size() == 2);
  CHECK(measurements[1].seconds == std::vector<double>{3, 5});
  CHECK(measurements[1].warmUp.seconds == 2 + 4);
  CHECK(measurements[1].warmUp.passes == 2);
  CHECK(measurements[0].warmUp.passes == 0);
  RayReport report{"device", "driver", {8, 8}, {64, 64}, 2, {}};
  report.rows.push_back({"room", 1, "bvh2", render::SceneLoads::texel, 1024, measurements[1]});
  CHECK_THAT(toText(report), Contains("each after a warm-up of 3.00 s"));
  CHECK(toJson(report)["rows"][0]["warmUpSeconds"] == 6);
}

TEST_CASE("a kind without rays is omitted, and a stop gives no measurements") {
  std::vector<std::string> log;
  FakeTracer a("a", log);
  RayTracer* const tracers[]{&a};
  CHECK(measureRays(tracers, setsOf(4, 0), 1, nullptr).size() == 1);
  const std::atomic<bool> stop = true;
  CHECK(measureRays(tracers, setsOf(4, 0), 1, &stop).empty());
}

TEST_CASE("a tracer with other hits has no figures, unless the difference is within its permitted fraction") {
  std::vector<std::string> log;
  FakeTracer a("a", log), wrong("wrong", log, 3), peer("peer", log, 3, false);
  RayTracer* const tracers[]{&a, &wrong, &peer};
  auto measurements = measureRays(tracers, setsOf(10, 0), 1, nullptr);
  REQUIRE(measurements.size() == 3);
  CHECK(measurements[0].equalFraction == 1);
  CHECK(measurements[1].equalFraction == Approx(0.9));
  CHECK(measurements[2].equalFraction == Approx(0.9));  // its distances differ, which is permitted for a peer
  RayReport report{"device", "driver", {8, 8}, {64, 64}, 1, {}};
  report.rows.push_back({"room", 1, "bvh2", render::SceneLoads::texel, 1024, measurements[0]});
  CHECK(report.agree());
  report.rows.push_back({"room", 1, "Embree", std::nullopt, 0, measurements[2], 0.85});
  CHECK(report.agree());
  report.rows.push_back({"room", 1, "cwbvh", render::SceneLoads::texel, 1024, measurements[1]});
  CHECK_FALSE(report.agree());
  CHECK_THAT(toText(report), Contains("differs"));
  const auto json = toJson(report);
  CHECK(json["schema"] == "candela-bench/2");
  CHECK(json["rows"][0]["agrees"] == true);
  for (const char* key :
       {"scene", "sceneHash", "rayKind", "layout", "sceneLoads", "medianSeconds", "spread", "mraysPerSecond"}) {
    CHECK(json["rows"][0].contains(key));
  }
  CHECK(json["rows"][2]["agrees"] == false);
  CHECK_FALSE(json["rows"][2].contains("mraysPerSecond"));
}

}  // namespace
}  // namespace candela::bench
