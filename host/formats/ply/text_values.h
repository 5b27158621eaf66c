// The numbers of a PLY file in ASCII.
#pragma once
#include <charconv>
#include <cmath>
#include <limits>
#include <string>

#include "host/formats/loading/diagnostic_log.h"
#include "host/formats/ply/ply_header.h"

namespace candela::ply {

/// Reads the numbers after the header one after the other. Those of an element may be on several lines; the next
/// element begins on a line of its own. Functions throw SceneError with line and column.
class TextValues {
 public:
  /// The file, the header and the log must outlive this object. With `lenient`, more numbers on a line than the header
  /// states cause a warning.
  TextValues(const scene::SceneFile& file, const Header& header, bool lenient, scene::DiagnosticLog& log)
      : file_(&file),
        next_(file.bytes.data() + header.size),
        end_(file.bytes.data() + file.bytes.size()),
        isLenient_(lenient),
        log_(&log) {}

  void beginRow(const Element& element, std::uint64_t index) {
    element_ = &element;
    index_ = index;
  }
  /// Throws unless the line ends.
  void endRow() {
    skipBlanks();
    if (next_ != end_ && !isLineEnd(*next_)) endLongRow();
  }

  /// A number, rounded once to single precision; an integer is checked for the range of its type. NaN for numbers that
  /// are not finite.
  float real(NumberType type) {
    if (isInteger(type)) return static_cast<float>(integer(type));
    begin();
    float value = 0;
    const auto [stop, error] = std::from_chars(next_, end_, value);
    if (error != std::errc() || !endsAt(stop)) return otherReal();
    next_ = stop;
    return std::isfinite(value) ? value : std::numeric_limits<float>::quiet_NaN();
  }
  /// A whole number.
  std::int64_t integer(NumberType type) {
    begin();
    std::int64_t value = 0;
    if (!readDigits(value)) value = otherInteger();
    if (isInteger(type) && (value > maxOf(type) || (value < 0 && value < minOf(type)))) failRange(value, type);
    return value;
  }
  /// Calls `action` with `count` whole numbers, one after the other.
  template <class Action>
  void integers(NumberType type, std::uint64_t count, const Action& action) {
    for (std::uint64_t i = 0; i < count; ++i) action(integer(type));
  }
  void skip(NumberType) {
    begin();
    while (!endsAt(next_)) ++next_;
  }
  void skip(NumberType type, std::uint64_t count) {
    for (std::uint64_t i = 0; i < count; ++i) skip(type);
  }

  /// The number of values that can still follow.
  std::uint64_t room(NumberType) const { return static_cast<std::uint64_t>(end_ - next_ + 1) / 2; }
  /// Returns whether nothing follows but blanks.
  bool isAtEnd();
  /// The place of the last number, for warnings.
  scene::Position position() const;
  /// Throws SceneError at the last number.
  [[noreturn]] void fail(const std::string& message) const;

 private:
  static bool isLineEnd(char c) { return c == '\n' || c == '\r'; }
  static bool isBlank(char c) { return c == ' ' || c == '\t'; }
  bool endsAt(const char* p) const { return p == end_ || isBlank(*p) || isLineEnd(*p); }
  void skipBlanks() {
    while (next_ != end_ && isBlank(*next_)) ++next_;
  }
  /// Reads a number of at most 15 digits without a sign. Returns false, and stays, if there is none.
  bool readDigits(std::int64_t& value) {
    constexpr std::ptrdiff_t kMaxDigits = 15;
    const char* p = next_;
    while (p != end_ && *p >= '0' && *p <= '9' && p - next_ < kMaxDigits) value = 10 * value + (*p++ - '0');
    if (p == next_ || !endsAt(p)) return false;
    next_ = p;
    return true;
  }
  /// Goes to the next number, which must exist.
  void begin() {
    while (next_ != end_ && (isBlank(*next_) || isLineEnd(*next_))) ++next_;
    word_ = next_;
    if (next_ == end_) fail("the file ends within the element");
  }
  std::string_view word() const;
  /// Read numbers in other notations, such as "-1" or "1e3" for an integer, and go to their end.
  float otherReal();
  std::int64_t otherInteger();
  void endLongRow();
  [[noreturn]] void failRange(std::int64_t value, NumberType type) const;

  const scene::SceneFile* file_;
  const char* next_;
  const char* end_;
  const char* word_ = next_;  ///< begin of the last number
  bool isLenient_;
  scene::DiagnosticLog* log_;
  const Element* element_ = nullptr;
  std::uint64_t index_ = 0;
};

}  // namespace candela::ply
