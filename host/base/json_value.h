// A JSON value together with its JSON pointer, and checked access to its content. For files that come from elsewhere.
#pragma once
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/errors.h"

namespace candela {

/// The value at `pointer` (RFC 6901) is wrong. `what()` is e.g. "/accessors/3/count: expected a number".
struct JsonError : FileError {
  JsonError(const std::string& pointer, const std::string& message)
      : FileError((pointer.empty() ? "the root" : pointer) + ": " + message) {}
  /// The same error with a hint at its end.
  JsonError(const JsonError& error, const std::string& hint) : FileError(error.what() + hint) {}
};

/// Every function except the first four throws JsonError if the value does not have the required type. Numbers are
/// finite in single precision.
class JsonValue {
 public:
  /// `json` must outlive this object.
  JsonValue(const nlohmann::json& json, std::string pointer) : json_(&json), pointer_(std::move(pointer)) {}

  const std::string& pointer() const { return pointer_; }
  const nlohmann::json& json() const { return *json_; }
  bool isNull() const { return json_->is_null(); }
  [[noreturn]] void fail(const std::string& message) const { throw JsonError(pointer_, message); }

  /// Returns a member of this object. If there is none, find() returns nothing, and findOrNull() a null value.
  std::optional<JsonValue> find(std::string_view key) const;
  JsonValue findOrNull(std::string_view key) const;
  JsonValue require(std::string_view key) const;
  /// The keys of this object, sorted.
  std::vector<std::string> keys() const;

  /// Elements of this array.
  std::size_t size() const;
  JsonValue operator[](std::size_t index) const;
  std::vector<JsonValue> items() const;

  double number() const;
  /// A whole number from 0 to 2^53.
  std::uint64_t whole() const;
  /// A whole number from `min` to `max`, which is at most 2^53.
  std::uint64_t whole(std::uint64_t min, std::uint64_t max) const;
  /// An index below `limit` into the list `list`.
  std::size_t indexInto(std::string_view list, std::size_t limit) const;
  bool boolean() const;
  const std::string& text() const;
  /// An array of as many numbers as Vector has components, such as glm::vec3.
  template <class Vector>
  Vector vector() const;

  /// The value of a member, or a default where there is no such member.
  double numberOr(std::string_view key, double absent) const;
  std::uint64_t wholeOr(std::string_view key, std::uint64_t absent) const;
  bool booleanOr(std::string_view key, bool absent) const;
  std::string textOr(std::string_view key, const std::string& absent) const;
  template <class Vector>
  Vector vectorOr(std::string_view key, const Vector& absent) const;
  /// The size of a member that is an array; 0 where there is none.
  std::size_t sizeOf(std::string_view key) const;

 private:
  JsonValue member(std::string_view key, const nlohmann::json& json) const;

  const nlohmann::json* json_;
  std::string pointer_;
};

template <class Vector>
Vector JsonValue::vector() const {
  constexpr auto kLength = static_cast<std::size_t>(Vector::length());
  if (size() != kLength) fail("expected an array of " + std::to_string(kLength) + " numbers");
  Vector result;
  for (std::size_t i = 0; i < kLength; ++i) {
    result[static_cast<typename Vector::length_type>(i)] = static_cast<typename Vector::value_type>(
        (*this)[i].number());
  }
  return result;
}

template <class Vector>
Vector JsonValue::vectorOr(std::string_view key, const Vector& absent) const {
  const std::optional<JsonValue> value = find(key);
  return value ? value->vector<Vector>() : absent;
}

}  // namespace candela
