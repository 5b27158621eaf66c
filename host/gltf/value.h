// A JSON value together with its place in the file, and checked access to its content.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "host/core/errors.h"

namespace candela::gltf {

/// Something at `pointer` (RFC 6901) is wrong. `what()` is "/accessors/3/count: expected ...".
struct PlaceError : FileError {
  PlaceError(const std::string& pointer, const std::string& message)
      : FileError((pointer.empty() ? "the root" : pointer) + ": " + message) {}
  /// The same error with a hint at its end.
  PlaceError(const PlaceError& error, const std::string& hint) : FileError(error.what() + hint) {}
};

/// Every function except the first three throws PlaceError if the value does not have the required type. Numbers
/// are finite.
class Value {
 public:
  /// `json` must outlive this object.
  Value(const nlohmann::json& json, std::string pointer) : json_(&json), pointer_(std::move(pointer)) {}

  const std::string& pointer() const { return pointer_; }
  const nlohmann::json& json() const { return *json_; }
  [[noreturn]] void fail(const std::string& message) const { throw PlaceError(pointer_, message); }

  /// Returns a member of this object; find() returns nothing if there is none.
  std::optional<Value> find(std::string_view key) const;
  Value require(std::string_view key) const;
  /// The member `name` of the member `extensions`, if there is one.
  std::optional<Value> extension(std::string_view name) const;

  /// Elements of this array.
  std::size_t size() const;
  Value operator[](std::size_t index) const;

  double number() const;
  /// A whole number from 0 to 2^53.
  std::uint64_t whole() const;
  /// An index below `limit` into the list `list`.
  std::size_t indexInto(std::string_view list, std::size_t limit) const;
  bool boolean() const;
  const std::string& text() const;
  /// Returns an array of as many numbers as Vector has components.
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
  Value member(std::string_view key, const nlohmann::json& json) const;

  const nlohmann::json* json_;
  std::string pointer_;
};

template <class Vector>
Vector Value::vector() const {
  constexpr auto kLength = static_cast<std::size_t>(Vector::length());
  if (size() != kLength) fail("expected an array of " + std::to_string(kLength) + " numbers");
  Vector result;
  for (std::size_t i = 0; i < kLength; ++i) {
    result[static_cast<glm::length_t>(i)] = static_cast<typename Vector::value_type>((*this)[i].number());
  }
  return result;
}

template <class Vector>
Vector Value::vectorOr(std::string_view key, const Vector& absent) const {
  const std::optional<Value> value = find(key);
  return value ? value->vector<Vector>() : absent;
}

}  // namespace candela::gltf
