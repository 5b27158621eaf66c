// Reads bytes sequentially, never beyond their end.
#pragma once
#include <algorithm>
#include <string_view>

#include "host/base/errors.h"
#include "host/image/codecs.h"

namespace candela::image {

class ByteCursor {
 public:
  explicit ByteCursor(ByteView bytes) : rest_(bytes) {}

  std::size_t remaining() const { return rest_.size(); }

  /// Returns the next `count` bytes. Throws FileError if there are fewer.
  ByteView take(std::size_t count) {
    if (count > rest_.size()) throw FileError("the file is truncated");
    const ByteView taken = rest_.first(count);
    rest_ = rest_.subspan(count);
    return taken;
  }

  /// Returns the next two bytes as a little-endian number.
  std::uint32_t takeHalf() {
    const std::uint32_t low = takeByte();
    return low | std::uint32_t{takeByte()} << 8;
  }

  /// Returns the next four bytes as a little-endian word.
  std::uint32_t takeWord() {
    const ByteView bytes = take(4);
    std::uint32_t word = 0;
    for (std::size_t i = 0; i < 4; ++i) word |= std::to_integer<std::uint32_t>(bytes[i]) << (8 * i);
    return word;
  }

  std::uint8_t takeByte() { return std::to_integer<std::uint8_t>(take(1)[0]); }

  /// Returns the characters before the first one for which `isEnd` is true, and skips that one. Throws FileError if
  /// there is none among the next `kMaxText` characters.
  template <typename Predicate>
  std::string_view takeUntil(Predicate isEnd) {
    constexpr std::size_t kMaxText = 4096;
    const std::string_view text(reinterpret_cast<const char*>(rest_.data()), std::min(rest_.size(), kMaxText));
    const auto end = std::find_if(text.begin(), text.end(), isEnd);
    if (end == text.end()) throw FileError("the header has no end");
    const auto length = static_cast<std::size_t>(end - text.begin());
    take(length + 1);
    return text.substr(0, length);
  }

 private:
  ByteView rest_;
};

}  // namespace candela::image
