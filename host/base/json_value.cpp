// Checked access to JSON values.
#include "host/base/json_value.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace candela {
namespace {

// The smallest number that single precision rounds to infinity. FLT_MAX is often written as 3.4028235e+38, which
// exceeds it.
constexpr double kRoundsToInfinity = 0x1.ffffffp127;
constexpr double kMaxWhole = 9007199254740992.0;  // 2^53: up to here JSON's numbers are exact

/// Writes a key as in RFC 6901, without control characters, and not longer than a line.
std::string escaped(std::string_view key) {
  constexpr std::size_t kMaxLength = 60;
  std::string text;
  for (const char c : key.substr(0, kMaxLength)) {
    if (c == '~' || c == '/') {
      text += c == '~' ? "~0" : "~1";
    } else {
      text += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
    }
  }
  return text + (key.size() > kMaxLength ? "..." : "");
}

}  // namespace

JsonValue JsonValue::member(std::string_view key, const nlohmann::json& json) const {
  return {json, pointer_ + '/' + escaped(key)};
}

std::optional<JsonValue> JsonValue::find(std::string_view key) const {
  if (!json_->is_object()) fail("expected an object");
  const auto found = json_->find(key);
  if (found == json_->end()) return std::nullopt;
  return member(key, *found);
}

JsonValue JsonValue::findOrNull(std::string_view key) const {
  static const nlohmann::json null;
  const std::optional<JsonValue> value = find(key);
  return value ? *value : member(key, null);
}

JsonValue JsonValue::require(std::string_view key) const {
  std::optional<JsonValue> value = find(key);
  if (!value) fail(fmt::format("the property \"{}\" is missing", key));
  return *std::move(value);
}

std::vector<std::string> JsonValue::keys() const {
  if (!json_->is_object()) fail("expected an object");
  std::vector<std::string> keys;
  for (const auto& [key, value] : json_->items()) keys.push_back(key);
  return keys;
}

std::size_t JsonValue::size() const {
  if (!json_->is_array()) fail("expected an array");
  return json_->size();
}

JsonValue JsonValue::operator[](std::size_t index) const {
  if (index >= size()) fail(fmt::format("expected at least {} elements", index + 1));
  return {(*json_)[index], fmt::format("{}/{}", pointer_, index)};
}

std::vector<JsonValue> JsonValue::items() const {
  std::vector<JsonValue> items;
  for (std::size_t i = 0; i < size(); ++i) items.push_back((*this)[i]);
  return items;
}

double JsonValue::number() const {
  if (!json_->is_number()) fail("expected a number");
  const double value = json_->get<double>();
  if (!(std::abs(value) < kRoundsToInfinity)) fail("the number is too large");
  return value;
}

std::uint64_t JsonValue::whole() const {
  const double value = json_->is_number() ? json_->get<double>() : -1;
  if (!(value >= 0 && value <= kMaxWhole && std::floor(value) == value)) fail("expected a whole number, 0 or more");
  return static_cast<std::uint64_t>(value);
}

std::uint64_t JsonValue::whole(std::uint64_t min, std::uint64_t max) const {
  const double value = json_->is_number() ? json_->get<double>() : -1;
  const bool isInside = value >= static_cast<double>(min) && value <= static_cast<double>(max);
  if (!isInside || std::floor(value) != value) fail(fmt::format("expected a whole number from {} to {}", min, max));
  return static_cast<std::uint64_t>(value);
}

std::size_t JsonValue::indexInto(std::string_view list, std::size_t limit) const {
  const std::uint64_t index = whole();
  if (index >= limit) fail(fmt::format("index {} into \"{}\", which has {} elements", index, list, limit));
  return static_cast<std::size_t>(index);
}

bool JsonValue::boolean() const {
  if (!json_->is_boolean()) fail("expected true or false");
  return json_->get<bool>();
}

const std::string& JsonValue::text() const {
  if (!json_->is_string()) fail("expected a string");
  return json_->get_ref<const std::string&>();
}

double JsonValue::numberOr(std::string_view key, double absent) const {
  const std::optional<JsonValue> value = find(key);
  return value ? value->number() : absent;
}

std::uint64_t JsonValue::wholeOr(std::string_view key, std::uint64_t absent) const {
  const std::optional<JsonValue> value = find(key);
  return value ? value->whole() : absent;
}

bool JsonValue::booleanOr(std::string_view key, bool absent) const {
  const std::optional<JsonValue> value = find(key);
  return value ? value->boolean() : absent;
}

std::string JsonValue::textOr(std::string_view key, const std::string& absent) const {
  const std::optional<JsonValue> value = find(key);
  return value ? value->text() : absent;
}

std::size_t JsonValue::sizeOf(std::string_view key) const {
  const std::optional<JsonValue> value = find(key);
  return value ? value->size() : 0;
}

}  // namespace candela
