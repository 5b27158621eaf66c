// Evaluates divisions of rows in parallel.
#include "host/base/statistics/permutation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "host/base/hash.h"
#include "host/base/run_on_threads.h"
#include "host/base/statistics/welch.h"

namespace candela::statistics {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Random divisions per 1/alpha: so many are expected to reach the critical score.
constexpr double kDivisionsPerLevel = 5;
constexpr double kMinDivisions = 1e4;
constexpr double kMaxDivisions = 1e6;
// Scores that are equal but for rounding are equal.
constexpr double kTie = 1e-9;
// The noise of a group counts as at least this fraction of that of the other one.
constexpr double kMinNoiseRatio = 1e-6;
// Standardised values keep a difference of the means of at most so many standard errors: a larger one is no noise.
constexpr double kMaxKeptDifference = 2;

// SplitMix64 with a state of its own for every division.
class Random {
 public:
  Random(std::uint64_t seed, std::uint64_t division) : state_(seed ^ (division * 0xd1342543de82ef95u)) { next(); }

  std::uint64_t next() { return splitMix(state_ += kSplitMixStep); }
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
// 1959), in a tenth of the time of the exact one. z^2 / 2 grows with t and with the degrees of freedom.
double wallaceFactor(double nu) { return (8 * nu + 1) / (8 * nu + 3); }

double halfSquaredZ(double squaredT, double nu) {
  const double factor = wallaceFactor(nu);
  return factor * factor * nu * std::log1p(squaredT / nu) / 2;
}
// Returns the t^2 of this z^2 / 2.
double squaredTOf(double halfSquaredZ, double nu) {
  const double factor = wallaceFactor(nu);
  return nu * std::expm1(2 * halfSquaredZ / (factor * factor * nu));
}
// Returns P(|T| > t).
double tailOf(double halfSquaredZ) { return std::erfc(std::sqrt(halfSquaredZ)); }

// The number of divisions to evaluate, and whether these are all of them.
struct DivisionCount {
  DivisionCount(double total, double alpha) {
    const double wanted = std::clamp(std::ceil(kDivisionsPerLevel / alpha), kMinDivisions, kMaxDivisions);
    isExhaustive = total <= wanted;
    evaluated = static_cast<std::uint64_t>(isExhaustive ? total : wanted);
  }

  std::uint64_t evaluated;
  bool isExhaustive;
};

// Quantities are evaluated in groups of this size, whose sums stay in registers.
constexpr std::size_t kLanes = 8;
using Lanes = std::array<double, kLanes>;

// Returns t^2 of a difference, without a branch where it is not needed: a division by 0 is well-defined.
double squaredT(double difference, double margin, double squaredError) {
  const double excess = std::max(0.0, std::abs(difference) - margin);
  const double square = excess * excess / squaredError;
  return excess > 0 ? square : 0;
}

// Whether a division exchanges the values themselves, or the values in units of the noise of their group.
enum class Exchanged : std::uint8_t { values, standardised };

// The standard deviation of one quantity in each group; 1 if it is taken to be equal.
struct Noise {
  double a = 1, b = 1;
};

// Returns the measured noise. A single row has that of the other group. Both are positive.
Noise noiseOf(const Rows& a, const Rows& b, std::size_t quantity) {
  Noise noise{a.size() > 1 ? std::sqrt(summarise(column(a, quantity)).variance) : 0,
              std::sqrt(summarise(column(b, quantity)).variance)};
  if (a.size() == 1) noise.a = noise.b;
  const double least = kMinNoiseRatio * std::max(noise.a, noise.b);
  return least > 0 ? Noise{std::max(noise.a, least), std::max(noise.b, least)} : Noise{};
}

// The rows of both groups, from each of which a value is subtracted for each quantity so that their sum is 0 after the
// division by the noise of their group. Sums of squares do not cancel. Zeros follow the last quantity, so that it can
// be read in groups.
class CentredRows {
 public:
  CentredRows(const Rows& a, const Rows& b, Exchanged exchanged) : countA_(a.size()), rows_(a) {
    rows_.insert(rows_.end(), b.begin(), b.end());
    const std::size_t quantities = rows_.front().size();
    squares_.assign(quantities + kLanes, 0);
    noise_.resize(quantities + kLanes);
    for (std::size_t q = 0; q < quantities; ++q) {
      if (exchanged == Exchanged::standardised) {
        noise_[q] = noiseOf(a, b, q);
        limitDifference(q);
      }
      centre(q);
    }
    for (auto& row : rows_) row.resize(quantities + kLanes);
  }

  std::size_t count() const { return rows_.size(); }
  const double* row(std::size_t index) const { return rows_[index].data(); }
  double squares(std::size_t quantity) const { return squares_[quantity]; }
  const Noise& noise(std::size_t quantity) const { return noise_[quantity]; }

 private:
  void limitDifference(std::size_t q) {
    const auto n = static_cast<double>(countA_), m = static_cast<double>(rows_.size() - countA_);
    double difference = 0;
    for (std::size_t i = 0; i < rows_.size(); ++i) difference += i < countA_ ? rows_[i][q] / n : -rows_[i][q] / m;
    const double most = kMaxKeptDifference * std::hypot(noise_[q].a / std::sqrt(n), noise_[q].b / std::sqrt(m));
    const double excess = difference - std::clamp(difference, -most, most);
    for (std::size_t i = 0; i < countA_; ++i) rows_[i][q] -= excess;
  }

  void centre(std::size_t q) {
    double sum = 0, weights = 0;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      sum += rows_[i][q] / noiseOfRow(i, q);
      weights += 1 / noiseOfRow(i, q);
    }
    const double mean = sum / weights;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      double& value = rows_[i][q];
      value = (value - mean) / noiseOfRow(i, q);
      squares_[q] += value * value;
    }
  }
  double noiseOfRow(std::size_t row, std::size_t q) const { return row < countA_ ? noise_[q].a : noise_[q].b; }

  std::size_t countA_;
  Rows rows_;
  std::vector<double> squares_;
  std::vector<Noise> noise_;
};

// The quantities [first, first + count).
struct Range {
  std::size_t first = 0;
  std::size_t count = 0;
};

// Some of the rows: those of the smaller group, or those whose sign changes.
using Chosen = std::vector<std::size_t>;

// The divisions, of which the first is that of the data, and the statistics of quantities in them.
class Design {
 public:
  virtual ~Design() = default;
  virtual Chosen rowsOf(std::uint64_t division) const = 0;
  // Writes the squares of t of a range of quantities to a buffer with room for kLanes more.
  virtual void squaredTs(const Chosen& chosen, const Range& range, double* squaredTs) const = 0;
  // Returns the degrees of freedom of one quantity, at most maxFreedom().
  virtual double freedom(const Chosen& chosen, std::size_t quantity) const = 0;
  virtual double maxFreedom() const = 0;
};

// The choice of the rows of the smaller group. Division 0 is that of the data.
class GroupDivisions {
 public:
  GroupDivisions(std::size_t rows, std::size_t chosen, bool isExhaustive, std::uint64_t seed)
      : rows_(rows), chosen_(chosen), isExhaustive_(isExhaustive), seed_(seed) {}

  // If the groups have equal sizes and exchange their values, exchanging the groups changes nothing, and the first row
  // stays where it is. These divisions have the lowest ranks.
  static double total(std::size_t rows, std::size_t chosen, Exchanged exchanged) {
    const bool hasMirrorImages = 2 * chosen == rows && exchanged == Exchanged::values;
    return hasMirrorImages ? binomial(rows - 1, chosen - 1) : binomial(rows, chosen);
  }

  Chosen rowsOf(std::uint64_t division) const {
    if (division == 0) return firstRows();
    return isExhaustive_ ? ofRank(static_cast<double>(division)) : drawn(division);
  }

 private:
  Chosen firstRows() const {
    Chosen rows(chosen_);
    std::iota(rows.begin(), rows.end(), 0);
    return rows;
  }

  // Returns the combination of this rank in lexicographic order.
  Chosen ofRank(double rank) const {
    Chosen rows;
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

  Chosen drawn(std::uint64_t division) const {
    Random random(seed_, division);
    Chosen rows(rows_);
    std::iota(rows.begin(), rows.end(), 0);
    for (std::size_t i = 0; i < chosen_; ++i) std::swap(rows[i], rows[i + random.below(rows_ - i)]);
    rows.resize(chosen_);
    return rows;
  }

  std::size_t rows_, chosen_;
  bool isExhaustive_;
  std::uint64_t seed_;
};

// Welch's statistic from the sums of the smaller group, in units of the noise; those of all rows are 0. A group of a
// single row has the variance of the other.
//
// The sums of both groups are opposite in every division, so that the errors of both means add up linearly in it. In
// the data they are independent, and their squares add up. The difference is scaled so that its variance over all
// divisions is that of the data; with equal noise, the factor is 1.
class WelchSums {
 public:
  WelchSums(std::size_t countA, std::size_t countB)
      : inverseA_(1 / static_cast<double>(countA)),
        inverseB_(1 / static_cast<double>(countB)),
        freedomOfA_(static_cast<double>(countA) - 1),
        freedomOfB_(static_cast<double>(countB) - 1),
        weightA_(countA > 1 ? inverseA_ / freedomOfA_ : 0),
        weightB_((inverseB_ + (countA > 1 ? 0 : inverseA_)) / freedomOfB_) {}

  // Returns the difference of the means for a sum of 1.
  double differenceOf(const Noise& noise) const {
    if (noise.a == noise.b) return noise.a * (inverseA_ + inverseB_);
    return std::sqrt((noise.a * noise.a * inverseA_ + noise.b * noise.b * inverseB_) * (inverseA_ + inverseB_));
  }

  double squaredT(double difference, double sum, double squares, double allSquares, const Noise& noise,
                  double margin) const {
    const double error = errorOfA(sum, squares, noise) + errorOfB(sum, allSquares - squares, noise);
    return statistics::squaredT(difference * sum, margin, error);
  }

  // Returns the degrees of freedom of Welch and Satterthwaite.
  double freedom(double sum, double squares, double allSquares, const Noise& noise) const {
    const double a = errorOfA(sum, squares, noise), b = errorOfB(sum, allSquares - squares, noise);
    const double uncertainty = (freedomOfA_ > 0 ? a * a / freedomOfA_ : 0) + b * b / freedomOfB_;
    return uncertainty > 0 ? std::min((a + b) * (a + b) / uncertainty, maxFreedom()) : maxFreedom();
  }
  double maxFreedom() const { return freedomOfA_ + freedomOfB_; }

 private:
  double errorOfA(double sum, double squares, const Noise& noise) const {
    return std::max(0.0, squares - sum * sum * inverseA_) * weightA_ * (noise.a * noise.a);
  }
  double errorOfB(double sum, double squares, const Noise& noise) const {
    return std::max(0.0, squares - sum * sum * inverseB_) * weightB_ * (noise.b * noise.b);
  }

  double inverseA_, inverseB_;
  double freedomOfA_, freedomOfB_;
  double weightA_, weightB_;  ///< of the sums of squared deviations in the squared error of the difference
};

// The signs of the differences. Division 0 is that of the data, and changing all signs changes nothing.
class SignDivisions {
 public:
  SignDivisions(std::size_t rows, bool isExhaustive, std::uint64_t seed)
      : rows_(rows), isExhaustive_(isExhaustive), seed_(seed) {}

  static double total(std::size_t rows) { return std::exp2(static_cast<double>(rows) - 1); }

  Chosen rowsOf(std::uint64_t division) const {
    Chosen changed;
    if (division == 0) return changed;
    Random random(seed_, division);
    for (std::size_t i = 1; i < rows_; ++i) {
      const bool isChanged = isExhaustive_ ? ((division >> (i - 1)) & 1) != 0 : (random.next() >> 63) != 0;
      if (isChanged) changed.push_back(i);
    }
    return changed;
  }

 private:
  std::size_t rows_;
  bool isExhaustive_;
  std::uint64_t seed_;
};

class Evaluation {
 public:
  Evaluation(const PermutationPlan& plan, PermutationTest& test) : plan_(plan), test_(test) {
    std::size_t first = 0;
    for (const std::size_t count : plan.families) {
      families_.push_back({first, count});
      first += count;
    }
    test_.pValue = 0;
    test_.pValues.assign(plan.margins.size(), 0);
    test_.criticalTails.assign(plan.families.size(), 1);
  }

  // The first division of the design is that of the data.
  void evaluateData(const Design& design) {
    const Chosen chosen = design.rowsOf(0);
    for (const Range& family : families_) {
      std::vector<double> squares(family.count + kLanes);
      design.squaredTs(chosen, family, squares.data());
      for (std::size_t i = 0; i < family.count; ++i) {
        test_.t.push_back(std::sqrt(squares[i]));
        test_.tails.push_back(tailOf(halfSquaredZ(squares[i], design.freedom(chosen, family.first + i))));
      }
    }
    data_ = scoreOf(design, 0);
  }

  // The p-values become at least those of these divisions, among which that of the data counts.
  void compareWith(const Design& design, std::uint64_t divisions) {
    std::vector<double> scores(divisions, data_);
    forEachBlock(plan_.threads, scores.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = std::max<std::size_t>(begin, 1); i < end; ++i) scores[i] = scoreOf(design, i);
    });
    std::sort(scores.begin() + 1, scores.end(), std::greater<>());  // the others, which define the critical score
    lowerCriticalTails(scores);
    std::sort(scores.begin(), scores.end(), std::greater<>());
    test_.pValue = std::max(test_.pValue, fractionFrom(scores, data_));
    for (const Range& family : families_) {
      for (std::size_t q = family.first; q < family.first + family.count; ++q) {
        test_.pValues[q] = std::max(test_.pValues[q], fractionFrom(scores, score(family.count, test_.tails[q])));
      }
    }
  }

 private:
  static double score(std::size_t count, double tail) { return -std::log(static_cast<double>(count) * tail); }

  double scoreOf(const Design& design, std::uint64_t division) const {
    const Chosen chosen = design.rowsOf(division);
    double largest = -kInfinity;
    for (const Range& family : families_) {
      largest = std::max(largest, score(family.count, tailOf(largestHalfSquaredZ(design, chosen, family))));
    }
    return largest;
  }

  // The degrees of freedom are calculated only for quantities that would be the largest with the most possible ones.
  static double largestHalfSquaredZ(const Design& design, const Chosen& chosen, const Range& family) {
    constexpr std::size_t kBlock = 1024;  // values of a block stay in the caches
    std::array<double, kBlock + kLanes> squares;
    double largest = 0, bound = 0;  // of z^2 / 2, and the t^2 that it needs at least
    for (std::size_t i = 0; i < family.count; i += kBlock) {
      const Range range{family.first + i, std::min(kBlock, family.count - i)};
      design.squaredTs(chosen, range, squares.data());
      for (std::size_t q = 0; q < range.count; ++q) {
        if (squares[q] <= bound) continue;
        const double candidate = halfSquaredZ(squares[q], design.freedom(chosen, range.first + q));
        if (candidate <= largest) continue;
        largest = candidate;
        bound = squaredTOf(largest, design.maxFreedom());
      }
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
  void lowerCriticalTails(const std::vector<double>& scores) {
    const auto k = static_cast<std::size_t>(plan_.alpha * static_cast<double>(scores.size()) + kTie);
    for (std::size_t i = 0; i < families_.size(); ++i) {
      const double count = static_cast<double>(families_[i].count);
      const double tail = k == 0 || k >= scores.size() ? 0 : std::exp(-scores[k]) / count;
      test_.criticalTails[i] = std::min(tail, test_.criticalTails[i]);
    }
  }

  const PermutationPlan& plan_;
  PermutationTest& test_;
  std::vector<Range> families_;
  double data_ = 0;  ///< the score of the data
};

std::vector<double> padded(std::vector<double> values) {
  values.resize(values.size() + kLanes);
  return values;
}

Rows paddedRows(Rows rows) {
  for (auto& row : rows) row = padded(std::move(row));
  return rows;
}

class GroupDesign final : public Design {
 public:
  // `chosen` rows come first.
  GroupDesign(CentredRows rows, std::size_t chosen, const PermutationPlan& plan, bool isExhaustive)
      : rows_(std::move(rows)),
        welch_(chosen, rows_.count() - chosen),
        margins_(padded(plan.margins)),
        divisions_(rows_.count(), chosen, isExhaustive, plan.seed) {
    for (std::size_t q = 0; q < margins_.size(); ++q) differences_.push_back(welch_.differenceOf(rows_.noise(q)));
  }

  Chosen rowsOf(std::uint64_t division) const override { return divisions_.rowsOf(division); }

  void squaredTs(const Chosen& chosen, const Range& range, double* squaredTs) const override {
    for (std::size_t i = 0; i < range.count; i += kLanes) {
      const std::size_t q = range.first + i;
      Lanes sums{}, squares{};
      for (const std::size_t row : chosen) {
        const double* const values = rows_.row(row) + q;
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
          sums[lane] += values[lane];
          squares[lane] += values[lane] * values[lane];
        }
      }
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        squaredTs[i + lane] = welch_.squaredT(differences_[q + lane], sums[lane], squares[lane],
                                              rows_.squares(q + lane), rows_.noise(q + lane), margins_[q + lane]);
      }
    }
  }

  double freedom(const Chosen& chosen, std::size_t quantity) const override {
    double sum = 0, squares = 0;
    for (const std::size_t row : chosen) {
      const double value = rows_.row(row)[quantity];
      sum += value;
      squares += value * value;
    }
    return welch_.freedom(sum, squares, rows_.squares(quantity), rows_.noise(quantity));
  }

  double maxFreedom() const override { return welch_.maxFreedom(); }

 private:
  CentredRows rows_;
  WelchSums welch_;
  std::vector<double> margins_, differences_;
  GroupDivisions divisions_;
};

class PairDesign final : public Design {
 public:
  PairDesign(const Rows& differences, const PermutationPlan& plan, bool isExhaustive)
      : rows_(paddedRows(differences)),
        margins_(padded(plan.margins)),
        sums_(margins_.size()),
        squares_(margins_.size()),
        divisions_(rows_.size(), isExhaustive, plan.seed) {
    for (const auto& row : rows_) {
      for (std::size_t q = 0; q < row.size(); ++q) {
        sums_[q] += row[q];
        squares_[q] += row[q] * row[q];
      }
    }
  }

  Chosen rowsOf(std::uint64_t division) const override { return divisions_.rowsOf(division); }

  void squaredTs(const Chosen& chosen, const Range& range, double* squaredTs) const override {
    const auto count = static_cast<double>(rows_.size());
    for (std::size_t i = 0; i < range.count; i += kLanes) {
      const std::size_t q = range.first + i;
      Lanes changed{};
      for (const std::size_t row : chosen) {
        const double* const values = rows_[row].data() + q;
        for (std::size_t lane = 0; lane < kLanes; ++lane) changed[lane] += values[lane];
      }
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        const double sum = sums_[q + lane] - 2 * changed[lane];
        const double mean = sum / count;
        const double deviations = std::max(0.0, squares_[q + lane] - sum * mean);
        squaredTs[i + lane] = squaredT(mean, margins_[q + lane], deviations / (count * (count - 1)));
      }
    }
  }

  double freedom(const Chosen&, std::size_t) const override { return maxFreedom(); }
  double maxFreedom() const override { return static_cast<double>(rows_.size()) - 1; }

 private:
  Rows rows_;
  std::vector<double> margins_, sums_, squares_;
  SignDivisions divisions_;
};

void noteDivisions(const DivisionCount& count, PermutationTest& test) {
  test.divisions = count.evaluated;
  test.isExhaustive = count.isExhaustive;
  test.minPValue = 1 / static_cast<double>(count.evaluated);
}

// Without variance, nothing can be tested.
PermutationTest untested(const PermutationPlan& plan) {
  PermutationTest test;
  test.t.assign(plan.margins.size(), 0);
  test.tails.assign(plan.margins.size(), 1);
  test.pValues.assign(plan.margins.size(), 1);
  test.criticalTails.assign(plan.families.size(), 0);
  return test;
}

}  // namespace

std::vector<double> column(const Rows& rows, std::size_t quantity) {
  std::vector<double> values;
  for (const auto& row : rows) values.push_back(row[quantity]);
  return values;
}

PermutationTest testGroups(const Rows& a, const Rows& b, const PermutationPlan& plan) {
  if (a.size() + b.size() < 3) return untested(plan);
  const Rows& smaller = a.size() <= b.size() ? a : b;
  const Rows& larger = a.size() <= b.size() ? b : a;
  const std::size_t chosen = smaller.size();
  PermutationTest test;
  Evaluation evaluation(plan, test);
  for (const Exchanged exchanged : {Exchanged::values, Exchanged::standardised}) {
    const DivisionCount count(GroupDivisions::total(a.size() + b.size(), chosen, exchanged), plan.alpha);
    const GroupDesign design(CentredRows(smaller, larger, exchanged), chosen, plan, count.isExhaustive);
    if (exchanged == Exchanged::values) {
      noteDivisions(count, test);
      evaluation.evaluateData(design);
    }
    evaluation.compareWith(design, count.evaluated);
  }
  return test;
}

PermutationTest testPairs(const Rows& differences, const PermutationPlan& plan) {
  if (differences.size() < 2) return untested(plan);
  PermutationTest test;
  const DivisionCount count(SignDivisions::total(differences.size()), plan.alpha);
  noteDivisions(count, test);
  const PairDesign design(differences, plan, count.isExhaustive);
  Evaluation evaluation(plan, test);
  evaluation.evaluateData(design);
  evaluation.compareWith(design, count.evaluated);
  return test;
}

}  // namespace candela::statistics
