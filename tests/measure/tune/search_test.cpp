// The search, with artificial measurements.
#include "host/measure/tune/search.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include "host/trace/device/pipeline_store.h"
#include "tests/measure/tune/made_rows.h"

namespace candela::tune {
namespace {

using Times = std::map<std::string, std::vector<MadeTime>>;  // by nameOf()

const std::string kBuiltIn = nameOf(builtIn());
const std::vector<MadeTime> kOneSecond{{1}, {1}};

// Every candidate takes a second on each of two scenes, except for those in `times`.
class MadeDevice {
 public:
  explicit MadeDevice(Times times) : times_(std::move(times)) {}

  SearchResult search(const vulkan::DeviceInfo& info = roomyDevice()) {
    return tune::search(info, 3, [this](std::span<const Candidate> candidates, std::uint32_t repeats) {
      repeatsOfRounds.push_back(repeats);
      std::vector<Row> rows;
      for (const Candidate& candidate : candidates) {
        const auto found = times_.find(nameOf(candidate));
        rows.push_back(madeRow(candidate, found == times_.end() ? kOneSecond : found->second, repeats));
        for (bench::RenderRow& scene : rows.back().scenes) scene.measurement.statistics.layout = layout;
      }
      if (afterFirstRound) times_ = *afterFirstRound;
      return rows;
    });
  }

  render::LayoutInUse layout = render::LayoutInUse::cwbvh;  ///< that the device uses
  std::vector<std::uint32_t> repeatsOfRounds;
  std::optional<Times> afterFirstRound;

 private:
  Times times_;
};

std::string named(const std::vector<std::pair<std::string, std::string>>& values) {
  return nameOf(candidateWith(values));
}

TEST_CASE("a gain is the geometric mean over the scenes of the ratios of medians") {
  const Row base = madeRow(builtIn(), {{1, 0.1}, {8, 0.1}});
  CHECK(gain(base, madeRow(builtIn(), {{0.5, 0.3}, {8, 0.3}})) == Approx(std::sqrt(2)));
  CHECK(gain(base, madeRow(builtIn(), {{0.5}, {16}})) == Approx(1));
  CHECK(gain(base, madeRow(builtIn(), {{0.5, 0, false}, {8}})) == 0);
}

TEST_CASE("noise is two standard errors of the medians, less over more runs and more scenes") {
  // Runs at 0.9, 1 and 1.1: a median absolute deviation of 0.1.
  const double error = 1.2533 * 1.4826 * 0.1 / std::sqrt(3);
  const Row one = madeRow(builtIn(), {{1, 0.1}});
  const Row two = madeRow(builtIn(), {{1, 0.1}, {5, 0.1}});
  CHECK(noise(one, one) == Approx(2 * std::sqrt(2) * error));
  CHECK(noise(two, two) == Approx(noise(one, one) / std::sqrt(2)));
  CHECK(noise(one, madeRow(builtIn(), {{1, 0}})) == Approx(2 * error));
  CHECK(noise(madeRow(builtIn(), {{1, 0.1}}, 9), madeRow(builtIn(), {{1, 0.1}}, 9)) < noise(one, one));
}

TEST_CASE("layouts are not compared where all scenes are traced as lists") {
  MadeDevice device(Times{{named({{"layout", "bvh2"}}), {{0.5}, {0.5}}}});
  CHECK(device.search().chosen == candidateWith({{"layout", "bvh2"}}));
  device.layout = render::LayoutInUse::list;
  const SearchResult result = device.search();
  CHECK(result.chosen == builtIn());
  CHECK_FALSE(result.tunesLayout);
  for (const Row& row : result.rounds.front().rows) CHECK_THAT(nameOf(row.candidate), Catch::Contains("layout=cwbvh"));
}

TEST_CASE("the candidate with the best geometric mean is chosen, not the best of any one scene") {
  const std::string chosen = named({{"layout", "bvh2"}});
  MadeDevice device(Times{{chosen, {{0.8}, {0.8}}}, {named({{"loads", "storage"}}), {{0.4}, {2}}}});
  const SearchResult result = device.search();
  CHECK(nameOf(result.chosen) == chosen);
  CHECK(result.chosenGain == Approx(1.25));
  CHECK(result.agree());
}

TEST_CASE("options of one stage are tried in all combinations, later stages with the results of earlier ones") {
  // Each value alone is slower.
  const std::string pair = named({{"layout", "bvh2"}, {"loads", "storage"}});
  const std::string all = named({{"layout", "bvh2"}, {"loads", "storage"}, {"workgroup", "32x1"}});
  MadeDevice device(Times{{named({{"layout", "bvh2"}}), {{2}, {2}}},
                          {named({{"loads", "storage"}}), {{2}, {2}}},
                          {pair, {{0.5}, {0.5}}},
                          {all, {{0.25}, {0.25}}}});
  const SearchResult result = device.search();
  CHECK(nameOf(result.chosen) == all);
  CHECK(result.chosenGain == Approx(4));
  REQUIRE(result.rounds.size() == 4);
  CHECK(result.rounds[0].purpose == "layout, loads");
  CHECK(result.rounds[1].purpose == "workgroup");
  CHECK(result.rounds[2].purpose == "kernel");
  CHECK(result.rounds[3].purpose == "confirmation");
  CHECK(device.repeatsOfRounds == std::vector<std::uint32_t>{3, 3, 3, 7});
  for (const Round& round : result.rounds) CHECK(nameOf(round.rows.front().candidate) == kBuiltIn);
}

TEST_CASE("the built-in choice stays unless another is faster by more than the minimum gain and the noise") {
  const std::string other = named({{"workgroup", "16x4"}});
  CHECK(nameOf(MadeDevice(Times{{other, {{1 / 1.015}, {1 / 1.015}}}}).search().chosen) == kBuiltIn);
  CHECK(nameOf(MadeDevice(Times{{other, {{1 / 1.025}, {1 / 1.025}}}}).search().chosen) == other);
  const auto noisy = [&](double deviation) {
    return MadeDevice(
               Times{{kBuiltIn, {{1, deviation}, {1, deviation}}}, {other, {{0.9, deviation}, {0.9, deviation}}}})
        .search();
  };
  CHECK(nameOf(noisy(0.2).chosen) == kBuiltIn);
  CHECK(nameOf(noisy(0.01).chosen) == other);
  CHECK(noisy(0.2).rounds.size() == 3);  // nothing to confirm
}

TEST_CASE("a candidate that was fast only in its own round fails the confirmation") {
  MadeDevice device(Times{{named({{"layout", "bvh2"}}), {{0.5}, {0.5}}}});
  device.afterFirstRound = Times{};
  const SearchResult result = device.search();
  CHECK(result.rounds.back().purpose == "confirmation");
  CHECK(nameOf(result.chosen) == kBuiltIn);
  CHECK(result.chosenGain == 1);
}

TEST_CASE("a candidate whose image differs is reported and never chosen") {
  const std::string wrong = named({{"layout", "bvh2"}});
  const std::string right = named({{"loads", "storage"}});
  const SearchResult result = MadeDevice(Times{{wrong, {{0.1}, {0.1, 0, false}}}, {right, {{0.5}, {0.5}}}}).search();
  CHECK(nameOf(result.chosen) == right);
  CHECK_FALSE(result.agree());
  CHECK(result.builtInAgrees);
}

TEST_CASE("a choice whose image differs in a later round is dropped") {
  MadeDevice device(Times{{named({{"layout", "bvh2"}}), {{0.5}, {0.5}}}});
  device.afterFirstRound = Times{{named({{"layout", "bvh2"}}), {{0.5, 0, false}, {0.5}}}};
  CHECK(nameOf(device.search().chosen) == kBuiltIn);
}

TEST_CASE("if the image of the built-in choice differs, nothing is chosen and nothing else is tried") {
  const SearchResult result = MadeDevice(Times{{kBuiltIn, {{1, 0, false}, {1}}},
                                               {named({{"layout", "bvh2"}}), {{0.5}, {0.5}}}})
                                  .search();
  CHECK_FALSE(result.builtInAgrees);
  CHECK_FALSE(result.agree());
  CHECK(result.rounds.size() == 1);
  CHECK(nameOf(result.chosen) == kBuiltIn);
}

TEST_CASE("workgroups that the device does not have are not tried") {
  vulkan::DeviceInfo small = roomyDevice();
  small.maxWorkgroupInvocations = 64;
  std::size_t shapes = 0;
  for (const Round& round : MadeDevice(Times{}).search(small).rounds) {
    for (const Row& row : round.rows) {
      CHECK(isFeasible(row.candidate, small));
      ++shapes;
    }
  }
  CHECK(shapes == 6 + 5 + 2);
}

TEST_CASE("no round has more candidates than a renderer caches pipelines") {
  const std::string found = named({{"layout", "bvh2"}, {"loads", "storage"}});
  const SearchResult result = MadeDevice(Times{{found, {{0.5}, {0.5}}}}).search();
  REQUIRE(result.rounds.size() == 4);
  for (const Round& round : result.rounds) CHECK(round.rows.size() <= device::PipelineStore::kCapacity);
}

}  // namespace
}  // namespace candela::tune
