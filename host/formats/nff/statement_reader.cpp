// Reads the numbers and words of one statement.
#include "host/formats/nff/statement_reader.h"

#include <fmt/format.h>

#include <cmath>

#include "host/base/quote.h"
#include "host/formats/loading/number.h"

namespace candela::scene {
namespace {

void requireValid(const Token& token, NumberStatus status) {
  const std::string text = quote(token.text);
  switch (status) {
    case NumberStatus::ok:
      return;
    case NumberStatus::notFinite:
      StatementReader::fail(token.position, text + " is not a finite number");
    case NumberStatus::overflow:
      StatementReader::fail(token.position, text + " is beyond the range of single precision (3.4e38)");
    case NumberStatus::notANumber:
      break;
  }
  const bool comma = token.text.find(',') != std::string_view::npos;
  StatementReader::fail(token.position, text + " is not a number" +
                                            (comma ? "; write decimals with a point, and blanks between numbers" : ""));
}

}  // namespace

Token StatementReader::begin(std::string_view form) {
  form_ = form;
  return tokens_->take();
}

void StatementReader::fail(Position position, std::string message) {
  throw StatementError{position, std::move(message)};
}

Position StatementReader::here() const { return tokens_->nextIsOnLine() ? tokens_->peek().position : tokens_->end(); }

void StatementReader::failExpecting(std::string_view what) const {
  const Token& next = tokens_->peek();
  std::string found = next.atEnd() ? "the end of the file" : quote(next.text);
  if (!next.atEnd() && !tokens_->nextIsOnLine()) found += fmt::format(" on line {}", next.position.line);
  fail(here(), fmt::format("expected {}, found {}; the form is: {}", what, found, form_));
}

Token StatementReader::takeNumber(std::string_view what) {
  if (!numberFollows()) failExpecting(what);
  lastNumber_ = tokens_->peek().position;
  return tokens_->take();
}

float StatementReader::number(std::string_view what) {
  const Token token = takeNumber(what);
  const auto [value, status] = parseFloat(token.text);
  if (status != NumberStatus::ok) requireValid(token, status);
  return value;
}

glm::vec3 StatementReader::vector(std::string_view what) {
  const float x = number(what);
  const float y = number(what);
  const float z = number(what);
  return {x, y, z};
}

std::int64_t StatementReader::wholeNumber(std::string_view what, std::int64_t min, std::int64_t max) {
  const Token token = takeNumber(what);
  const auto [value, status] = parseDouble(token.text);
  requireValid(token, status);
  const bool inRange = value >= static_cast<double>(min) && value <= static_cast<double>(max);
  if (inRange && value == std::floor(value)) return static_cast<std::int64_t>(value);
  fail(token.position,
       fmt::format("{} must be a whole number from {} to {}, not {}", what, min, max, quote(token.text)));
}

Token StatementReader::word(std::string_view what) {
  if (!tokens_->nextIsOnLine()) failExpecting(what);
  return tokens_->take();
}

bool StatementReader::numberFollows() const { return looksLikeNumber(tokens_->peek().text); }
bool StatementReader::numberOnLine() const { return tokens_->nextIsOnLine() && numberFollows(); }

std::vector<float> StatementReader::numbersOnLine(std::size_t maxCount) {
  std::vector<float> numbers;
  while (numbers.size() < maxCount && numberOnLine()) numbers.push_back(number({}));
  return numbers;
}

void StatementReader::skipStatement() {
  while (tokens_->nextIsOnLine()) tokens_->take();
  while (numberFollows()) {
    tokens_->take();
    while (tokens_->nextIsOnLine()) tokens_->take();
  }
}

}  // namespace candela::scene
