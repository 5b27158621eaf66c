// Reads Radiance RGBE files (Greg Ward, "Real Pixels", Graphics Gems II): uncompressed, and both kinds of run-length
// encoding.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "host/image/byte_cursor.h"
#include "host/image/chromaticities.h"

namespace candela::image {
namespace {

using Rgbe = std::array<std::uint8_t, 4>;

/// One of the two axes of the resolution line.
struct Axis {
  bool isY = false;
  bool isReversed = false;  ///< from the bottom or from the right
  std::uint32_t size = 0;
};

struct Header {
  Axis slow, fast;         ///< the axes of the scan lines, and of the pixels in a scan line
  glm::dvec3 exposure{1};  ///< by which the pixels were multiplied
  std::optional<Chromaticities> primaries;
  std::vector<std::string> warnings;
};

[[noreturn]] void refuse(const char* what) { throw FileError(std::string("not a valid HDR file: ") + what); }

std::string_view takeLine(ByteCursor& cursor) {
  return cursor.takeUntil([](char c) { return c == '\n'; });
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

/// Reads `count` numbers after the name of a variable.
std::optional<std::vector<double>> takeNumbers(std::string_view text, std::size_t count) {
  std::vector<double> numbers;
  for (std::size_t i = 0; i < count; ++i) {
    const auto number = takeNumber<double>(text);
    if (!number || !std::isfinite(*number)) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

/// Applies EXPOSURE or COLORCORR. Several are multiplied.
void multiplyExposure(std::string_view name, std::string_view value, Header& header) {
  const std::size_t count = name == "COLORCORR" ? 3 : 1;
  const auto numbers = takeNumbers(value, count);
  if (!numbers || !std::ranges::all_of(*numbers, [](double number) { return number > 0; })) {
    header.warnings.push_back(fmt::format("{}={} is ignored, since it is not positive", name, value));
    return;
  }
  for (int c = 0; c < 3; ++c) header.exposure[c] *= (*numbers)[count == 3 ? static_cast<std::size_t>(c) : 0];
}

void takeVariable(std::string_view line, Header& header) {
  const std::size_t equals = std::min(line.find('='), line.size());
  const std::string_view name = line.substr(0, equals), value = line.substr(std::min(equals + 1, line.size()));
  if (name == "FORMAT" && value != "32-bit_rle_rgbe") {
    throw FileError(fmt::format("HDR files of the format {} are not read, only those of 32-bit_rle_rgbe", value));
  }
  if (name == "EXPOSURE" || name == "COLORCORR") multiplyExposure(name, value, header);
  if (name == "GAMMA" && takeNumbers(value, 1).value_or(std::vector{0.0})[0] != 1) {
    header.warnings.push_back(fmt::format("GAMMA={} is ignored", value));
  }
  if (name == "PRIMARIES") {
    const auto xy = takeNumbers(value, 8);
    if (xy) {
      const std::vector<double>& v = *xy;
      header.primaries = Chromaticities{{v[0], v[1]}, {v[2], v[3]}, {v[4], v[5]}, {v[6], v[7]}};
    } else {
      header.warnings.push_back(fmt::format("PRIMARIES={} is ignored, since it is not eight numbers", value));
    }
  }
}

/// Reads an axis such as "-Y 480".
Axis takeAxis(std::string_view& line) {
  constexpr const char* kForms = "its size is not one of the eight forms of \"-Y height +X width\"";
  if (line.size() < 3 || (line[0] != '-' && line[0] != '+') || (line[1] != 'Y' && line[1] != 'X')) refuse(kForms);
  Axis axis{.isY = line[1] == 'Y'};
  axis.isReversed = axis.isY == (line[0] == '+');
  line.remove_prefix(2);
  const auto size = takeNumber<std::uint32_t>(line);
  if (!size) refuse(kForms);
  axis.size = *size;
  line.remove_prefix(std::min(line.find_first_not_of(" \r"), line.size()));
  return axis;
}

Header takeHeader(ByteCursor& cursor) {
  takeLine(cursor);  // "#?RADIANCE" or "#?RGBE"
  Header header;
  for (std::string_view line = takeLine(cursor); !line.empty(); line = takeLine(cursor)) takeVariable(line, header);
  const bool isUsable = glm::all(glm::lessThan(header.exposure, glm::dvec3(1e100))) &&
                        glm::all(glm::greaterThan(header.exposure, glm::dvec3(1e-100)));
  if (!isUsable) refuse("its exposures are too large or too small");
  std::string_view line = takeLine(cursor);
  header.slow = takeAxis(line);
  header.fast = takeAxis(line);
  if (!line.empty() || header.slow.isY == header.fast.isY) refuse("its size has not both a width and a height");
  checkImageSize(header.fast.size, header.slow.size);
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
glm::vec3 toLinear(const Rgbe& pixel, const glm::dvec3& exposure) {
  if (pixel[3] == 0) return glm::vec3(0);
  const double unit = std::ldexp(1.0, int{pixel[3]} - 136);
  return glm::vec3(glm::dvec3(pixel[0], pixel[1], pixel[2]) * unit / exposure);
}

/// Brings scan lines of any direction into rows from the top, and pixels from the left.
void orient(const Header& header, Image& image) {
  const Axis& x = header.slow.isY ? header.fast : header.slow;
  const Axis& y = header.slow.isY ? header.slow : header.fast;
  image.width = x.size;
  image.height = y.size;
  if (header.slow.isY && !x.isReversed && !y.isReversed) return;
  std::vector<glm::vec3> oriented(image.rgb.size());
  std::size_t i = 0;
  for (std::uint32_t line = 0; line < header.slow.size; ++line) {
    for (std::uint32_t k = 0; k < header.fast.size; ++k) {
      const std::uint32_t column = header.slow.isY ? k : line, row = header.slow.isY ? line : k;
      const std::size_t left = x.isReversed ? x.size - 1 - column : column;
      const std::size_t top = y.isReversed ? y.size - 1 - row : row;
      oriented[top * x.size + left] = image.rgb[i++];
    }
  }
  image.rgb = std::move(oriented);
}

}  // namespace

Image decodeHdr(ByteView file) {
  ByteCursor cursor(file);
  const Header header = takeHeader(cursor);
  Image image;
  image.significandBits = 8;
  std::vector<Rgbe> line(header.fast.size);
  for (std::uint32_t i = 0; i < header.slow.size; ++i) {  // memory grows with the actual content of the file
    takeRow(cursor, line);
    for (const Rgbe& pixel : line) image.rgb.push_back(toLinear(pixel, header.exposure));
  }
  orient(header, image);
  image.warnings = header.warnings;
  if (header.primaries) convertToRec709(*header.primaries, image);
  return image;
}

}  // namespace candela::image
