// Evaluates divisions of rows in parallel.
#include "host/base/statistics/permutation.h"

#include <algorithm>
#include <array>
#include <boost/math/special_functions/erf.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>

#include "host/base/run_on_threads.h"

namespace candela::statistics {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Random divisions per 1/alpha: so many are expected to reach the critical score.
constexpr double kDivisionsPerLevel = 5;
constexpr double kMinDivisions = 1e4;
constexpr double kMaxDivisions = 1e6;
// Scores that are equal but for rounding are equal.
constexpr double kTie = 1e-9;

// A generator with a state of its own for every division (splitmix64; Steele, Lea and Flood 2014).
class Random {
 public:
  Random(std::uint64_t seed, std::uint64_t division) : state_(seed ^ (division * 0xd1342543de82ef95u)) { next(); }

  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  // Returns an integer below `count` < 2^32.
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(((next() >> 32) * count) >> 32); }

 private:
  std::uint64_t state_;
};

double binomial(std::size_t n, std::size_t k) {
  double product = 1;
  for (std::size_t i = 1; i <= std::min(k, n - k); ++i) {
    product = product * static_cast<double>(n - i + 1) / static_cast<double>(i);
  }
  return std::round(product);
}

// Student's distribution by the normal distribution of a transformed t (Wallace, Annals of Mathematical Statistics 30,
// 1959), in a tenth of the time of the exact one.
class Student {
 public:
  explicit Student(double degreesOfFreedom)
      : nu_(degreesOfFreedom), factor_((8 * nu_ + 1) / (8 * nu_ + 3) / std::numbers::sqrt2) {}

  // Returns P(|T| > t).
  double tail(double t) const { return std::erfc(factor_ * std::sqrt(nu_ * std::log1p(t * t / nu_))); }
  // Returns the t whose tail this is, in (0, 1].
  double quantile(double tail) const {
    const double z = boost::math::erfc_inv(tail) / factor_;
    return std::sqrt(nu_ * std::expm1(z * z / nu_));
  }

 private:
  double nu_, factor_;
};

// The number of divisions to evaluate, and whether these are all of `total`.
void chooseDivisions(double total, double alpha, PermutationTest& test) {
  const double wanted = std::clamp(std::ceil(kDivisionsPerLevel / alpha), kMinDivisions, kMaxDivisions);
  test.isExhaustive = total <= wanted;
  test.divisions = static_cast<std::uint64_t>(test.isExhaustive ? total : wanted);
  test.minPValue = 1 / static_cast<double>(test.divisions);
}

// Quantities are evaluated in groups of this size, whose sums stay in registers.
constexpr std::size_t kLanes = 8;
using Lanes = std::array<double, kLanes>;

// Returns t^2 of a difference, without a branch where it is not needed: a division by 0 is well-defined.
double squaredT(double difference, double margin, double squaredError) {
  const double excess = std::max(0.0, std::abs(difference) - margin);
  const double square = excess * excess / squaredError;
  return excess > 0 ? square : 0;
}

// Rows from which the mean of all rows is subtracted, so that sums of squares do not cancel. Zeros follow the last
// quantity, so that it can be read in groups.
class CentredRows {
 public:
  CentredRows(const Rows& a, const Rows& b) : rows_(a) {
    rows_.insert(rows_.end(), b.begin(), b.end());
    const std::size_t quantities = rows_.front().size();
    squares_.assign(quantities + kLanes, 0);
    for (std::size_t q = 0; q < quantities; ++q) centre(q);
    for (auto& row : rows_) row.resize(quantities + kLanes);
  }

  std::size_t count() const { return rows_.size(); }
  const double* row(std::size_t index) const { return rows_[index].data(); }
  double squares(std::size_t quantity) const { return squares_[quantity]; }

 private:
  void centre(std::size_t q) {
    double sum = 0;
    for (const auto& row : rows_) sum += row[q];
    const double mean = sum / static_cast<double>(rows_.size());
    for (auto& row : rows_) {
      row[q] -= mean;
      squares_[q] += row[q] * row[q];
    }
  }

  Rows rows_;
  std::vector<double> squares_;
};

// The quantities [first, first + count).
struct Range {
  std::size_t first = 0;
  std::size_t count = 0;
};

// Writes the squares of t of a range of quantities, in the division of an index, to a buffer with room for kLanes more.
using Statistics = std::function<void(std::uint64_t division, const Range& range, double* squaredTs)>;

// The choice of the rows of the smaller group. Division 0 is that of the data.
class GroupDivisions {
 public:
  // If the groups have equal sizes, exchanging them changes nothing, and the first row stays where it is.
  GroupDivisions(std::size_t rows, std::size_t chosen, bool isExhaustive, std::uint64_t seed)
      : rows_(rows), chosen_(chosen), isExhaustive_(isExhaustive), seed_(seed) {}

  static double total(std::size_t rows, std::size_t chosen) {
    return 2 * chosen == rows ? binomial(rows - 1, chosen - 1) : binomial(rows, chosen);
  }

  std::vector<std::size_t> rowsOf(std::uint64_t division) const {
    if (division == 0) return firstRows();
    return isExhaustive_ ? ofRank(static_cast<double>(division)) : drawn(division);
  }

 private:
  std::vector<std::size_t> firstRows() const {
    std::vector<std::size_t> rows(chosen_);
    std::iota(rows.begin(), rows.end(), 0);
    return rows;
  }

  // Returns the combination of this rank in lexicographic order.
  std::vector<std::size_t> ofRank(double rank) const {
    std::vector<std::size_t> rows;
    for (std::size_t row = 0; rows.size() < chosen_; ++row) {
      const double withRow = binomial(rows_ - row - 1, chosen_ - rows.size() - 1);
      if (rank < withRow) {
        rows.push_back(row);
      } else {
        rank -= withRow;
      }
    }
    return rows;
  }

  std::vector<std::size_t> drawn(std::uint64_t division) const {
    Random random(seed_, division);
    std::vector<std::size_t> rows(rows_);
    std::iota(rows.begin(), rows.end(), 0);
    for (std::size_t i = 0; i < chosen_; ++i) std::swap(rows[i], rows[i + random.below(rows_ - i)]);
    rows.resize(chosen_);
    return rows;
  }

  std::size_t rows_, chosen_;
  bool isExhaustive_;
  std::uint64_t seed_;
};

// Welch's statistic from the sums of the smaller group; those of all rows are 0. A group of a single row has the
// variance of the other.
class WelchSums {
 public:
  WelchSums(std::size_t countA, std::size_t countB)
      : inverseA_(1 / static_cast<double>(countA)),
        inverseB_(1 / static_cast<double>(countB)),
        weightA_(countA > 1 ? inverseA_ / static_cast<double>(countA - 1) : 0),
        weightB_((inverseB_ + (countA > 1 ? 0 : inverseA_)) / static_cast<double>(countB - 1)) {}

  double squaredT(double sum, double squares, double allSquares, double margin) const {
    const double deviationsA = std::max(0.0, squares - sum * sum * inverseA_);
    const double deviationsB = std::max(0.0, allSquares - squares - sum * sum * inverseB_);
    return statistics::squaredT(sum * (inverseA_ + inverseB_), margin, deviationsA * weightA_ + deviationsB * weightB_);
  }

 private:
  double inverseA_, inverseB_;
  double weightA_, weightB_;  ///< of the sums of squared deviations in the squared error of the difference
};

// The signs of the differences. Division 0 is that of the data, and changing all signs changes nothing.
class SignDivisions {
 public:
  SignDivisions(std::size_t rows, bool isExhaustive, std::uint64_t seed)
      : rows_(rows), isExhaustive_(isExhaustive), seed_(seed) {}

  static double total(std::size_t rows) { return std::exp2(static_cast<double>(rows) - 1); }

  std::vector<double> signsOf(std::uint64_t division) const {
    std::vector<double> signs(rows_, 1);
    if (division == 0) return signs;
    Random random(seed_, division);
    for (std::size_t i = 1; i < rows_; ++i) {
      const bool isNegative = isExhaustive_ ? ((division >> (i - 1)) & 1) != 0 : (random.next() >> 63) != 0;
      if (isNegative) signs[i] = -1;
    }
    return signs;
  }

 private:
  std::size_t rows_;
  bool isExhaustive_;
  std::uint64_t seed_;
};

class Evaluation {
 public:
  Evaluation(const PermutationPlan& plan, PermutationTest& test, Statistics statistics)
      : plan_(plan), test_(test), statistics_(std::move(statistics)), student_(test.degreesOfFreedom) {
    std::size_t first = 0;
    for (const std::size_t count : plan.families) {
      families_.push_back({first, count});
      first += count;
    }
  }

  void run() {
    evaluateData();
    std::vector<double> scores(test_.divisions);
    forEachBlock(plan_.threads, scores.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t division = begin; division < end; ++division) scores[division] = scoreOf(division);
    });
    const double data = scores.front();
    std::sort(scores.begin() + 1, scores.end(), std::greater<>());  // the others, which define the critical score
    test_.criticalT = criticalTs(scores);
    std::sort(scores.begin(), scores.end(), std::greater<>());
    test_.pValue = fractionFrom(scores, data);
    for (const Range& family : families_) {
      for (std::size_t q = family.first; q < family.first + family.count; ++q) {
        test_.pValues.push_back(fractionFrom(scores, score(family.count, test_.t[q])));
      }
    }
  }

 private:
  void evaluateData() {
    for (const Range& family : families_) {
      std::vector<double> squares(family.count + kLanes);
      statistics_(0, family, squares.data());
      for (std::size_t i = 0; i < family.count; ++i) test_.t.push_back(std::sqrt(squares[i]));
    }
  }

  double score(std::size_t count, double t) const { return -std::log(static_cast<double>(count) * student_.tail(t)); }

  double scoreOf(std::uint64_t division) const {
    constexpr std::size_t kBlock = 1024;  // values of a block stay in the caches
    std::vector<double> squares(kBlock + kLanes);
    double largest = -kInfinity;
    for (const Range& family : families_) {
      double maximum = 0;
      for (std::size_t i = 0; i < family.count; i += kBlock) {
        const Range range{family.first + i, std::min(kBlock, family.count - i)};
        statistics_(division, range, squares.data());
        for (std::size_t q = 0; q < range.count; ++q) maximum = std::max(maximum, squares[q]);
      }
      largest = std::max(largest, score(family.count, std::sqrt(maximum)));
    }
    return largest;
  }

  // `scores` descend.
  static double fractionFrom(const std::vector<double>& scores, double score) {
    const double bound = std::isinf(score) ? score : score - kTie * std::max(1.0, std::abs(score));
    const auto end = std::partition_point(scores.begin(), scores.end(), [&](double other) { return other >= bound; });
    return static_cast<double>(end - scores.begin()) / static_cast<double>(scores.size());
  }

  // The data would be significant with a score above the k-th largest of the others, where k divisions are a fraction
  // alpha of all. `scores` descend after the first, which is that of the data.
  std::vector<double> criticalTs(const std::vector<double>& scores) const {
    const auto k = static_cast<std::size_t>(plan_.alpha * static_cast<double>(scores.size()) + kTie);
    std::vector<double> critical;
    for (const Range& family : families_) {
      critical.push_back(k == 0 || k >= scores.size() ? kInfinity : tOf(scores[k], family.count));
    }
    return critical;
  }

  double tOf(double score, std::size_t count) const {
    const double tail = std::exp(-score) / static_cast<double>(count);
    if (tail <= 0) return kInfinity;
    return student_.quantile(std::min(tail, 1.0));
  }

  const PermutationPlan& plan_;
  PermutationTest& test_;
  Statistics statistics_;
  Student student_;
  std::vector<Range> families_;
};

std::vector<double> padded(std::vector<double> values) {
  values.resize(values.size() + kLanes);
  return values;
}

Rows paddedRows(Rows rows) {
  for (auto& row : rows) row = padded(std::move(row));
  return rows;
}

// Without variance, nothing can be tested.
PermutationTest untested(const PermutationPlan& plan) {
  PermutationTest test;
  test.t.assign(plan.margins.size(), 0);
  test.pValues.assign(plan.margins.size(), 1);
  test.criticalT.assign(plan.families.size(), kInfinity);
  return test;
}

}  // namespace

PermutationTest testGroups(const Rows& a, const Rows& b, const PermutationPlan& plan) {
  if (a.size() + b.size() < 3) return untested(plan);
  const bool isASmaller = a.size() <= b.size();
  const CentredRows rows = isASmaller ? CentredRows(a, b) : CentredRows(b, a);
  const std::size_t chosen = std::min(a.size(), b.size());

  PermutationTest test;
  test.degreesOfFreedom = static_cast<double>(rows.count()) - 2;
  chooseDivisions(GroupDivisions::total(rows.count(), chosen), plan.alpha, test);
  const GroupDivisions divisions(rows.count(), chosen, test.isExhaustive, plan.seed);
  const WelchSums welch(chosen, rows.count() - chosen);
  const std::vector<double> margins = padded(plan.margins);
  Evaluation(plan, test, [&](std::uint64_t division, const Range& range, double* squaredTs) {
    const std::vector<std::size_t> chosenRows = divisions.rowsOf(division);
    for (std::size_t i = 0; i < range.count; i += kLanes) {
      const std::size_t q = range.first + i;
      Lanes sums{}, squares{};
      for (const std::size_t row : chosenRows) {
        const double* const values = rows.row(row) + q;
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
          sums[lane] += values[lane];
          squares[lane] += values[lane] * values[lane];
        }
      }
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        squaredTs[i + lane] = welch.squaredT(sums[lane], squares[lane], rows.squares(q + lane), margins[q + lane]);
      }
    }
  }).run();
  return test;
}

PermutationTest testPairs(const Rows& differences, const PermutationPlan& plan) {
  if (differences.size() < 2) return untested(plan);
  std::vector<double> squares(differences.front().size());
  for (const auto& row : differences) {
    for (std::size_t q = 0; q < row.size(); ++q) squares[q] += row[q] * row[q];
  }
  const Rows rows = paddedRows(differences);
  squares = padded(squares);
  const std::vector<double> margins = padded(plan.margins);

  PermutationTest test;
  const auto count = static_cast<double>(differences.size());
  test.degreesOfFreedom = count - 1;
  chooseDivisions(SignDivisions::total(differences.size()), plan.alpha, test);
  const SignDivisions divisions(differences.size(), test.isExhaustive, plan.seed);
  Evaluation(plan, test, [&](std::uint64_t division, const Range& range, double* squaredTs) {
    const std::vector<double> signs = divisions.signsOf(division);
    for (std::size_t i = 0; i < range.count; i += kLanes) {
      const std::size_t q = range.first + i;
      Lanes sums{};
      for (std::size_t row = 0; row < rows.size(); ++row) {
        const double* const values = rows[row].data() + q;
        for (std::size_t lane = 0; lane < kLanes; ++lane) sums[lane] += signs[row] * values[lane];
      }
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        const double mean = sums[lane] / count;
        const double deviations = std::max(0.0, squares[q + lane] - sums[lane] * mean);
        squaredTs[i + lane] = squaredT(mean, margins[q + lane], deviations / (count * (count - 1)));
      }
    }
  }).run();
  return test;
}

}  // namespace candela::statistics
