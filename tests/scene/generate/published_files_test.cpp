// Generated scenes, compared with the files that the original programs print.
#include <catch2/catch.hpp>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>

#include "tests/scene/generate/generated_text.h"

namespace candela {
namespace {

namespace fs = std::filesystem;

std::optional<double> number(const std::string& word) {
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
  return value;
}

/// One in the last of six digits.
double lastDigit(double value) { return std::pow(10, std::floor(std::log10(std::abs(value))) - 5); }

/// Equal to printed precision. What should be 0 is printed with the rounding errors that made it 1e-16.
bool agree(double a, double b) {
  constexpr double kNoise = 1e-12;
  const double difference = std::abs(a - b);
  if (difference < kNoise) return true;
  return difference <= 1.001 * std::min(lastDigit(a), lastDigit(b));
}

bool wordsAgree(const std::string& a, const std::string& b) {
  const auto x = number(a);
  const auto y = number(b);
  return x && y ? agree(*x, *y) : a == b;
}

bool linesAgree(const std::string& a, const std::string& b) {
  std::istringstream left(a);
  std::istringstream right(b);
  std::string x;
  std::string y;
  while (left >> x) {
    if (!(right >> y) || !wordsAgree(x, y)) return false;
  }
  return !(right >> y);
}

}  // namespace

TEST_CASE("two lines agree if their words do, numbers to the last printed digit") {
  CHECK(linesAgree("s 1.62187 0 -1.11022e-16", "s 1.62188 -0 0"));
  CHECK_FALSE(linesAgree("s 1.62187 0", "s 1.62189 0"));
  CHECK_FALSE(linesAgree("s 0.00350044", "s 0.00350046"));
  CHECK_FALSE(linesAgree("s 1", "c 1"));
  CHECK_FALSE(linesAgree("s 1 2", "s 1"));
  CHECK_FALSE(linesAgree("s 1", "s 1 2"));
}

TEST_CASE("generated scenes have the lines of the published files, numbers to the last printed digit") {
  std::size_t files = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(CANDELA_SOURCE_DIR) / "tests/formats/nff/spd")) {
    if (entry.path().extension() != ".nff") continue;
    ++files;
    const std::string name = entry.path().stem().string();  // KIND_SIZE
    const std::size_t underscore = name.find('_');
    std::ifstream expected(entry.path());
    std::istringstream actual(
        generatedText(name.substr(0, underscore), static_cast<std::uint32_t>(std::stoul(name.substr(underscore + 1)))));
    std::string expectedLine;
    std::string actualLine;
    for (int line = 1; std::getline(expected, expectedLine); ++line) {
      INFO(name << ":" << line << ": expected " << expectedLine);
      REQUIRE(std::getline(actual, actualLine));
      INFO("generated " << actualLine);
      REQUIRE(linesAgree(expectedLine, actualLine));
    }
    CAPTURE(name);
    CHECK_FALSE(std::getline(actual, actualLine));
  }
  CHECK(files == 17);
}

}  // namespace candela
