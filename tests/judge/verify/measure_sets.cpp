// Prints, as rows of a Markdown table, the false alarms of comparisons of sets of made renders, and their power:
//   measure_sets RUNS POWER_RUNS
// Power is the relative bias that is found in nine of ten comparisons, of the whole image and of a square of 8 x 8
// pixels, at the levels 0.05 and 0.01; `none`: 16 times the light is not found.
#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "tests/judge/verify/set_cases.h"

namespace candela::verify {
namespace {

constexpr double kMaxBias = 16;

// Returns the smallest bias that this comparison finds, to 2 %; kMaxBias if it is not smaller.
double smallestFound(const SetCase& one, const SetPictures& pictures, double alpha, std::uint32_t side) {
  double low = 1e-3, high = kMaxBias;
  while (high / low > 1.02) {
    const double middle = std::sqrt(low * high);
    (testPictures(one, pictures, alpha, 1 + middle, side).differs() ? high : low) = middle;
  }
  return high;
}

// Returns the bias that nine of ten comparisons find.
double foundNineTimesInTen(const SetCase& one, std::uint32_t runs, double alpha, std::uint32_t side) {
  std::vector<double> found;
  for (std::uint32_t run = 0; run < runs; ++run) {
    found.push_back(smallestFound(one, picturesOf(one, run), alpha, side));
  }
  const auto at = static_cast<std::ptrdiff_t>(found.size() * 9 / 10);
  std::nth_element(found.begin(), found.begin() + at, found.end());
  return found[static_cast<std::size_t>(at)];
}

void measure(const SetCase& one, std::uint32_t runs, std::uint32_t powerRuns) {
  int alarmsOf5 = 0, alarmsOf1 = 0;
  for (std::uint32_t run = 0; run < runs; ++run) {
    const SetPictures pictures = picturesOf(one, run);
    const double pValue = testPictures(one, pictures, 0.01).pValue;  // it does not depend on the level
    alarmsOf5 += pValue <= 0.05 ? 1 : 0;
    alarmsOf1 += pValue <= 0.01 ? 1 : 0;
  }
  std::printf("| %s | %d | %d |", one.name, alarmsOf5, alarmsOf1);
  for (const std::uint32_t side : {32u, 8u}) {
    for (const double alpha : {0.05, 0.01}) {
      const double found = foundNineTimesInTen(one, powerRuns, alpha, side);
      found < kMaxBias ? std::printf(" %.2g %% |", 100 * found) : std::printf(" none |");
    }
  }
  std::printf("\n");
  std::fflush(stdout);
}

}  // namespace
}  // namespace candela::verify

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fputs("usage: measure_sets RUNS POWER_RUNS\n", stderr);
    return 1;
  }
  for (const auto& cases : {candela::verify::setCases(), candela::verify::pictureCases()}) {
    for (const candela::verify::SetCase& one : cases) {
      candela::verify::measure(one, static_cast<std::uint32_t>(std::atoi(argv[1])),
                               static_cast<std::uint32_t>(std::atoi(argv[2])));
    }
  }
  return 0;
}
