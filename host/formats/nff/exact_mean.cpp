// Parses the comment "# exact-mean: ...".
#include "host/formats/nff/exact_mean.h"

#include <vector>

#include "host/formats/nff/number.h"
#include "host/formats/nff/tokenizer.h"

namespace candela::scene {
namespace {

constexpr std::string_view kKey = "exact-mean:";
constexpr const char*
    kForm = "the form is: # exact-mean: r g b [x y width height], with the rectangle in fractions of the image";

// Returns the position of the first number, or npos if the line is not such a comment.
std::size_t numbersOf(std::string_view line) {
  const std::size_t hash = line.find_first_not_of(" \t");
  if (hash == std::string_view::npos || line[hash] != '#') return std::string_view::npos;
  const std::size_t key = line.find_first_not_of(" \t", hash + 1);
  if (key == std::string_view::npos || !line.substr(key).starts_with(kKey)) return std::string_view::npos;
  return key + kKey.size();
}

bool isInside(const glm::vec4& area) {
  return area.x >= 0 && area.y >= 0 && area.z > 0 && area.w > 0 && area.x + area.z <= 1 && area.y + area.w <= 1;
}

std::optional<ExactMean> parseNumbers(std::string_view words) {
  std::vector<float> numbers;
  for (Tokenizer tokens(words); !tokens.peek().atEnd();) {
    const ParsedNumber<float> number = parseFloat(tokens.take().text);
    if (number.status != NumberStatus::ok) return std::nullopt;
    numbers.push_back(number.value);
  }
  if (numbers.size() != 3 && numbers.size() != 7) return std::nullopt;
  ExactMean exact{{numbers[0], numbers[1], numbers[2]}};
  if (numbers.size() == 7) exact.area = {numbers[3], numbers[4], numbers[5], numbers[6]};
  const bool isLight = exact.rgb.r >= 0 && exact.rgb.g >= 0 && exact.rgb.b >= 0;
  return isLight && isInside(exact.area) ? std::optional(exact) : std::nullopt;
}

}  // namespace

std::optional<ExactMean> findExactMean(std::string_view text, DiagnosticLog& log) {
  std::uint32_t lineNumber = 1;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find_first_of("\r\n"));
    const std::size_t numbers = numbersOf(line);
    if (numbers != std::string_view::npos) {
      const std::optional<ExactMean> exact = parseNumbers(line.substr(numbers));
      if (!exact) log.error({lineNumber, static_cast<std::uint32_t>(numbers + 1)}, kForm);
      return exact;
    }
    text.remove_prefix(line.size());
    text.remove_prefix(text.starts_with("\r\n") ? 2 : text.empty() ? 0 : 1);
    ++lineNumber;
  }
  return std::nullopt;
}

}  // namespace candela::scene
