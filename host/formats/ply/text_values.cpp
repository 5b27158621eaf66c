// Rare notations of numbers, and errors.
#include "host/formats/ply/text_values.h"

#include <fmt/format.h>

#include "host/base/quote.h"
#include "host/formats/loading/number.h"
#include "host/formats/loading/text_position.h"

namespace candela::ply {

using scene::NumberStatus;
using scene::quote;

std::string_view TextValues::word() const {
  const char* end = word_;
  while (!endsAt(end)) ++end;
  return {word_, static_cast<std::size_t>(end - word_)};
}

float TextValues::otherReal() {
  const std::string_view text = word();
  const scene::ParsedNumber<float> number = scene::parseFloat(text);
  if (number.status == NumberStatus::notANumber) fail(quote(text) + " is not a number");
  if (number.status == NumberStatus::overflow) fail(quote(text) + " is beyond the range of single precision");
  next_ = word_ + text.size();
  return number.status == NumberStatus::notFinite ? std::numeric_limits<float>::quiet_NaN() : number.value;
}

std::int64_t TextValues::otherInteger() {
  constexpr double kLimit = 9e15;  // doubles below it are exact integers
  const std::string_view text = word();
  const scene::ParsedNumber<double> number = scene::parseDouble(text);
  const bool isWhole = number.status == NumberStatus::ok && std::trunc(number.value) == number.value;
  if (!isWhole || std::abs(number.value) > kLimit) fail(quote(text) + " is not a whole number");
  next_ = word_ + text.size();
  return static_cast<std::int64_t>(number.value);
}

void TextValues::endLongRow() {
  word_ = next_;
  const std::string message = fmt::format("unexpected {}: the header states fewer numbers for the element {}",
                                          quote(word()), quote(element_->name));
  if (!isLenient_) fail(message);
  log_->warn("long row", position(), message + "; skipped");
  while (next_ != end_ && !isLineEnd(*next_)) ++next_;
}

bool TextValues::isAtEnd() {
  while (next_ != end_ && (isBlank(*next_) || isLineEnd(*next_))) ++next_;
  word_ = next_;
  return next_ == end_;
}

scene::Position TextValues::position() const {
  return scene::positionIn(file_->bytes, static_cast<std::size_t>(word_ - file_->bytes.data()));
}

void TextValues::fail(const std::string& message) const {
  const auto [line, column] = position();
  throw scene::SceneError(
      {{file_->name, line, column, fmt::format("element {} {}: {}", quote(element_->name), index_, message)}});
}

void TextValues::failRange(std::int64_t value, NumberType type) const {
  fail(fmt::format("{} is outside the range of {}, {} to {}", value, nameOf(type), minOf(type), maxOf(type)));
}

}  // namespace candela::ply
