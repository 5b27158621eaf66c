// Reads Radiance RGBE files (Greg Ward, "Real Pixels", Graphics Gems II): uncompressed, and both kinds of run-length
// encoding.
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "host/image/byte_cursor.h"

namespace candela::image {
namespace {

using Rgbe = std::array<std::uint8_t, 4>;

struct Header {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  double exposure = 1;
};

[[noreturn]] void refuse(const char* what) { throw FileError(std::string("not a valid HDR file: ") + what); }

std::string_view takeLine(ByteCursor& cursor) {
  return cursor.takeUntil([](char c) { return c == '\n'; });
}

/// Removes `prefix` from `text`. Returns whether it was there.
bool skip(std::string_view& text, std::string_view prefix) {
  if (!text.starts_with(prefix)) return false;
  text.remove_prefix(prefix.size());
  return true;
}

template <typename Number>
std::optional<Number> takeNumber(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc()) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return number;
}

/// Reads variables up to an empty line. Several exposures are multiplied.
double takeExposure(ByteCursor& cursor) {
  double exposure = 1;
  for (std::string_view line = takeLine(cursor); !line.empty(); line = takeLine(cursor)) {
    if (skip(line, "FORMAT=") && line != "32-bit_rle_rgbe") refuse("only 32-bit_rle_rgbe is read");
    if (skip(line, "EXPOSURE=")) exposure *= takeNumber<double>(line).value_or(0);
  }
  if (!(exposure > 0) || !std::isfinite(exposure)) refuse("EXPOSURE is not a positive number");
  return exposure;
}

Header takeHeader(ByteCursor& cursor) {
  takeLine(cursor);  // "#?RADIANCE" or "#?RGBE"
  Header header;
  header.exposure = takeExposure(cursor);
  std::string_view line = takeLine(cursor);
  if (!skip(line, "-Y ")) refuse("only rows from the top are read (\"-Y height +X width\")");
  const auto height = takeNumber<std::uint32_t>(line);
  if (!height || !skip(line, " +X ")) refuse("only columns from the left are read (\"-Y height +X width\")");
  const auto width = takeNumber<std::uint32_t>(line);
  if (!width || !line.empty()) refuse("its size is not a number");
  checkImageSize(*width, *height);
  header.width = *width;
  header.height = *height;
  return header;
}

Rgbe takePixel(ByteCursor& cursor) {
  const ByteView bytes = cursor.take(4);
  Rgbe pixel;
  for (std::size_t i = 0; i < 4; ++i) pixel[i] = std::to_integer<std::uint8_t>(bytes[i]);
  return pixel;
}

/// Reads one channel of a row. A count above 128 repeats the next byte count - 128 times; any other copies count bytes.
void takeChannel(ByteCursor& cursor, std::vector<Rgbe>& row, std::size_t channel) {
  std::size_t x = 0;
  while (x < row.size()) {
    const std::uint8_t code = cursor.takeByte();
    const bool isRun = code > 128;
    const std::size_t count = isRun ? code - 128u : code;
    if (count == 0 || count > row.size() - x) refuse("a run is longer than its row");
    const ByteView bytes = cursor.take(isRun ? 1 : count);
    for (std::size_t i = 0; i < count; ++i) row[x + i][channel] = std::to_integer<std::uint8_t>(bytes[isRun ? 0 : i]);
    x += count;
  }
}

/// Reads pixels as stored, except that (1, 1, 1, n) repeats the last pixel n times; the k-th such pixel in a sequence
/// repeats it n * 256^(k-1) times.
void takeOldRow(ByteCursor& cursor, std::vector<Rgbe>& row, const Rgbe& first) {
  Rgbe pixel = first;
  int shift = 0;
  std::size_t x = 0;
  while (true) {
    const bool isRun = pixel[0] == 1 && pixel[1] == 1 && pixel[2] == 1;
    if (isRun && (x == 0 || shift > 16)) refuse("a run has no pixel to repeat");
    const std::size_t count = isRun ? std::size_t{pixel[3]} << shift : 1;
    if (count > row.size() - x) refuse("a run is longer than its row");
    const Rgbe value = isRun ? row[x - 1] : pixel;
    for (std::size_t i = 0; i < count; ++i) row[x + i] = value;
    x += count;
    shift = isRun ? shift + 8 : 0;
    if (x == row.size()) return;
    pixel = takePixel(cursor);
  }
}

void takeRow(ByteCursor& cursor, std::vector<Rgbe>& row) {
  const Rgbe first = takePixel(cursor);
  const bool isNew = first[0] == 2 && first[1] == 2 && first[2] < 128 && row.size() >= 8 && row.size() < 32768;
  if (!isNew) return takeOldRow(cursor, row, first);
  if (first[2] * 256u + first[3] != row.size()) refuse("a row has a different width");
  for (std::size_t channel = 0; channel < 4; ++channel) takeChannel(cursor, row, channel);
}

/// Returns m * 2^(e - 136), as most programs do, so that 1 stays 1 and files with rounded mantissas, such as those of
/// encodeHdr(), have no bias. (Ward's own code truncates when it writes, and adds 1/2 to m when it reads.)
glm::vec3 toLinear(const Rgbe& pixel, double exposure) {
  if (pixel[3] == 0) return glm::vec3(0);
  const double unit = std::ldexp(1.0, int{pixel[3]} - 136) / exposure;
  return glm::vec3(glm::dvec3(pixel[0], pixel[1], pixel[2]) * unit);
}

}  // namespace

Image decodeHdr(ByteView file) {
  ByteCursor cursor(file);
  const Header header = takeHeader(cursor);
  Image image{header.width, header.height, {}, {}, {}, {}, {}};
  std::vector<Rgbe> row(header.width);
  for (std::uint32_t y = 0; y < header.height; ++y) {  // memory grows with the actual content of the file
    takeRow(cursor, row);
    for (const Rgbe& pixel : row) image.rgb.push_back(toLinear(pixel, header.exposure));
  }
  return image;
}

}  // namespace candela::image
