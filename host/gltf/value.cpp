// Checked access to JSON values.
#include "host/gltf/value.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace candela::gltf {
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

Value Value::member(std::string_view key, const nlohmann::json& json) const {
  return {json, pointer_ + '/' + escaped(key)};
}

std::optional<Value> Value::find(std::string_view key) const {
  if (!json_->is_object()) fail("expected an object");
  const auto found = json_->find(key);
  if (found == json_->end()) return std::nullopt;
  return member(key, *found);
}

Value Value::require(std::string_view key) const {
  std::optional<Value> value = find(key);
  if (!value) fail(fmt::format("the property \"{}\" is missing", key));
  return *std::move(value);
}

std::optional<Value> Value::extension(std::string_view name) const {
  const std::optional<Value> extensions = find("extensions");
  return extensions ? extensions->find(name) : std::nullopt;
}

std::size_t Value::size() const {
  if (!json_->is_array()) fail("expected an array");
  return json_->size();
}

Value Value::operator[](std::size_t index) const {
  if (index >= size()) fail(fmt::format("expected at least {} elements", index + 1));
  return {(*json_)[index], fmt::format("{}/{}", pointer_, index)};
}

double Value::number() const {
  if (!json_->is_number()) fail("expected a number");
  const double value = json_->get<double>();
  if (!(std::abs(value) < kRoundsToInfinity)) fail("the number is too large");
  return value;
}

std::uint64_t Value::whole() const {
  const double value = json_->is_number() ? json_->get<double>() : -1;
  if (!(value >= 0 && value <= kMaxWhole && std::floor(value) == value)) fail("expected a whole number, 0 or more");
  return static_cast<std::uint64_t>(value);
}

std::size_t Value::indexInto(std::string_view list, std::size_t limit) const {
  const std::uint64_t index = whole();
  if (index >= limit) fail(fmt::format("index {} into \"{}\", which has {} elements", index, list, limit));
  return static_cast<std::size_t>(index);
}

bool Value::boolean() const {
  if (!json_->is_boolean()) fail("expected true or false");
  return json_->get<bool>();
}

const std::string& Value::text() const {
  if (!json_->is_string()) fail("expected a string");
  return json_->get_ref<const std::string&>();
}

double Value::numberOr(std::string_view key, double absent) const {
  const std::optional<Value> value = find(key);
  return value ? value->number() : absent;
}

std::uint64_t Value::wholeOr(std::string_view key, std::uint64_t absent) const {
  const std::optional<Value> value = find(key);
  return value ? value->whole() : absent;
}

bool Value::booleanOr(std::string_view key, bool absent) const {
  const std::optional<Value> value = find(key);
  return value ? value->boolean() : absent;
}

std::string Value::textOr(std::string_view key, const std::string& absent) const {
  const std::optional<Value> value = find(key);
  return value ? value->text() : absent;
}

std::size_t Value::sizeOf(std::string_view key) const {
  const std::optional<Value> value = find(key);
  return value ? value->size() : 0;
}

}  // namespace candela::gltf
