// The numbers of a binary PLY file.
#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include "host/base/quote.h"
#include "host/formats/loading/diagnostic.h"
#include "host/formats/ply/ply_header.h"

namespace candela::ply {

/// Reads the numbers after the header one after the other, in one of both orders of bytes. It has the functions of
/// TextValues. Errors have the element and the offset of the byte in the file.
template <bool isBigEndian>
class BinaryValues {
 public:
  /// The file and the header must outlive this object.
  BinaryValues(const scene::SceneFile& file, const Header& header)
      : file_(&file), next_(file.bytes.data() + header.size), end_(file.bytes.data() + file.bytes.size()) {}

  void beginRow(const Element& element, std::uint64_t index) {
    element_ = &element;
    index_ = index;
  }
  void endRow() {}

  float real(NumberType type) {
    float value = 0;
    visit(type, [&](auto number) { value = static_cast<float>(number); });
    return std::isfinite(value) ? value : std::numeric_limits<float>::quiet_NaN();
  }
  std::int64_t integer(NumberType type) {
    if (!isInteger(type)) return wholeOf(type);
    std::int64_t value = 0;
    visit(type, [&](auto number) { value = static_cast<std::int64_t>(number); });
    return value;
  }
  template <class Action>
  void integers(NumberType type, std::uint64_t count, const Action& action) {
    if (type != NumberType::int32 || count > room(type)) {
      for (std::uint64_t i = 0; i < count; ++i) action(integer(type));
    } else {  // the usual case
      for (std::uint64_t i = 0; i < count; ++i) action(std::int64_t{load<std::int32_t>()});
    }
  }
  void skip(NumberType type) { skip(type, 1); }
  void skip(NumberType type, std::uint64_t count) {
    if (count > room(type)) failEnd();
    word_ = next_;
    next_ += count * sizeOf(type);
  }

  std::uint64_t room(NumberType type) const { return static_cast<std::uint64_t>(end_ - next_) / sizeOf(type); }
  bool isAtEnd() {
    word_ = next_;
    return next_ == end_;
  }
  static scene::Position position() { return {}; }
  [[noreturn]] void fail(const std::string& message) const {
    throw scene::SceneError({{file_->name, 0, 0,
                              fmt::format("element {} {} at byte {}: {}", scene::quote(element_->name), index_,
                                          word_ - file_->bytes.data(), message)}});
  }

 private:
  template <class Number>
  Number load() {
    if (static_cast<std::size_t>(end_ - next_) < sizeof(Number)) failEnd();
    word_ = next_;
    std::array<char, sizeof(Number)> bytes;
    std::memcpy(bytes.data(), next_, sizeof(Number));
    next_ += sizeof(Number);
    if constexpr (isBigEndian != (std::endian::native == std::endian::big)) std::ranges::reverse(bytes);
    return std::bit_cast<Number>(bytes);
  }

  template <class Action>
  void visit(NumberType type, const Action& action) {
    switch (type) {
      case NumberType::int8:
        return action(load<std::int8_t>());
      case NumberType::uint8:
        return action(load<std::uint8_t>());
      case NumberType::int16:
        return action(load<std::int16_t>());
      case NumberType::uint16:
        return action(load<std::uint16_t>());
      case NumberType::int32:
        return action(load<std::int32_t>());
      case NumberType::uint32:
        return action(load<std::uint32_t>());
      case NumberType::float32:
        return action(load<float>());
      case NumberType::float64:
        return action(load<double>());
    }
  }

  std::int64_t wholeOf(NumberType type) {
    constexpr double kLimit = 9e15;  // doubles below it are exact integers
    double value = 0;
    visit(type, [&](auto number) { value = static_cast<double>(number); });
    if (!(std::abs(value) < kLimit) || std::trunc(value) != value) fail(fmt::format("{} is not a whole number", value));
    return static_cast<std::int64_t>(value);
  }

  [[noreturn]] void failEnd() {
    word_ = next_;
    fail("the file ends within the element");
  }

  const scene::SceneFile* file_;
  const char* next_;
  const char* end_;
  const char* word_ = next_;  ///< begin of the last number
  const Element* element_ = nullptr;
  std::uint64_t index_ = 0;
};

}  // namespace candela::ply
