// Comparisons of sets of made renders, for the false alarms and the power of the test of two sets.
#pragma once
#include <vector>

#include "host/judge/verify/picture_test.h"
#include "tests/judge/verify/made_renders.h"

namespace candela::verify {

struct SetCase {
  const char* name;
  std::size_t countA, countB;
  MadeOptions a, b;
  SetDesign design = SetDesign::independent;  ///< paired: half of each render is common to its pair
  int leastAlarms = 25;                       ///< of 1,000 at the level 0.05, so that the test is not too strict
  bool holdsLevel = true;                     ///< else the renders of a set show too little of its noise
};

inline std::vector<SetCase> setCases() {
  constexpr auto kIndependent = SetDesign::independent;
  const MadeOptions light{}, heavy{.tail = Tail::pareto, .isSplatted = true};
  const MadeOptions fireflies{.tail = Tail::fireflies, .isSplatted = true};
  const MadeOptions splatted{.isSplatted = true}, finer{.samples = 8, .isSplatted = true};
  const MadeOptions finest{.samples = 32, .isSplatted = true};
  const MadeOptions finerHeavy{.samples = 8, .tail = Tail::pareto, .isSplatted = true};
  const MadeOptions finerFireflies{.samples = 8, .tail = Tail::fireflies, .isSplatted = true};
  const MadeOptions finerLeft{.samples = 8, .samplesOnRight = 2, .isSplatted = true};
  const MadeOptions finerRight{.samples = 2, .samplesOnRight = 8, .isSplatted = true};
  // Outliers of one set also look like unequal noise, which makes the test stricter.
  constexpr int kFew = 10;
  return {{"6 and 6, exponential, box filter", 6, 6, light, light},
          {"6 and 6, exponential, splatted", 6, 6, splatted, splatted},
          {"6 and 6, infinite variance, splatted", 6, 6, heavy, heavy, kIndependent, kFew},
          {"5 and 9, fireflies, splatted", 5, 9, fireflies, fireflies, kIndependent, kFew},
          {"1 and 19, fireflies, splatted", 1, 19, fireflies, fireflies},
          {"10 pairs, infinite variance, splatted", 10, 10, heavy, heavy, SetDesign::paired},
          {"8 and 8, of 8 and 2 samples, splatted", 8, 8, finer, splatted},
          {"8 and 8, of 32 and 2 samples, splatted", 8, 8, finest, splatted},
          {"10 and 10, of 8 and 2 samples, splatted", 10, 10, finer, splatted},
          {"6 and 18, of 2 and 8 samples, splatted", 6, 18, splatted, finer},
          {"6 and 18, of 8 and 2 samples, splatted", 6, 18, finer, splatted},
          {"6 and 10, of 2 and 8 samples, splatted", 6, 10, splatted, finer},
          {"5 and 9, of 2 and 32 samples, splatted", 5, 9, splatted, finest},
          {"5 and 9, of 32 and 2 samples, splatted", 5, 9, finest, splatted},
          {"8 and 8, of 8 and 2 samples in one half, 2 and 8 in the other, splatted", 8, 8, finerLeft, finerRight},
          {"8 and 8, of 8 and 2 samples, infinite variance, splatted", 8, 8, finerHeavy, heavy},
          {"8 and 8, of 8 and 2 samples, fireflies, splatted", 8, 8, finerFireflies, fireflies},
          {"5 and 9, of 2 and 8 samples, splatted", 5, 9, splatted, finer, kIndependent, 25, false},
          {"5 and 9, of 2 and 8 samples, fireflies, splatted", 5, 9, fireflies, finerFireflies, kIndependent, 0, false},
          {"1 and 19, of 2 and 8 samples, splatted", 1, 19, splatted, finer, kIndependent, 0, false}};
}

struct SetPictures {
  std::vector<image::Image> a, b;
};

/// Returns the renders of one comparison, whose seeds no other index below 2^20 has.
inline SetPictures picturesOf(const SetCase& one, std::uint32_t index) {
  const auto mixed = [](const image::Image& own, const image::Image& common) {
    image::Image mean = own;
    for (std::size_t i = 0; i < mean.rgb.size(); ++i) mean.rgb[i] = 0.5f * (own.rgb[i] + common.rgb[i]);
    return mean;
  };
  std::uint32_t seed = index * 128;
  SetPictures pictures;
  for (std::size_t i = 0; i < one.countA; ++i) pictures.a.push_back(MadeRender(seed++, one.a).image());
  for (std::size_t i = 0; i < one.countB; ++i) pictures.b.push_back(MadeRender(seed++, one.b).imageWithVariances());
  if (one.design != SetDesign::paired) return pictures;
  for (std::size_t i = 0; i < one.countA; ++i) {
    const image::Image common = MadeRender(seed++, one.a).image();
    pictures.a[i] = mixed(pictures.a[i], common);
    pictures.b[i] = mixed(pictures.b[i], common);
  }
  return pictures;
}

/// Comparisons of renders with a picture of many samples that has variances.
inline std::vector<SetCase> pictureCases() {
  const MadeOptions light{.isSplatted = true}, fireflies{.tail = Tail::fireflies, .isSplatted = true};
  const auto converged = [](MadeOptions options) {
    options.samples = 128;
    return options;
  };
  return {{"8 and a picture of 128 samples, exponential, splatted", 8, 1, light, converged(light), SetDesign::picture},
          {"8 and a picture of 128 samples, fireflies, splatted", 8, 1, fireflies, converged(fireflies),
           SetDesign::picture}};
}

/// Tests the renders, A's multiplied by `factor` in the square of `side` pixels in the middle.
inline SetTestResult testPictures(const SetCase& one, const SetPictures& pictures, double alpha, double factor = 1,
                                  std::uint32_t side = 32) {
  RenderSet a, b;
  for (image::Image picture : pictures.a) {
    const std::uint32_t first = (picture.width - side) / 2;
    for (std::uint32_t y = first; y < first + side; ++y) {
      for (std::uint32_t x = first; x < first + side; ++x) picture.at(x, y) *= static_cast<float>(factor);
    }
    a.add(picture);
  }
  for (const image::Image& picture : pictures.b) b.add(picture);
  if (one.design == SetDesign::picture) {
    const image::Image& picture = pictures.b.front();
    const auto count = static_cast<std::uint32_t>(a.count() * one.a.samples);
    return testAgainstPicture(a, {std::vector(picture.rgb.size(), count)}, picture, {.alpha = alpha});
  }
  return testRenderSets(a, b, {.design = one.design, .alpha = alpha, .threads = 1});
}

}  // namespace candela::verify
