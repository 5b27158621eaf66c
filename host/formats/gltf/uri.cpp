// Decodes URIs.
#include "host/formats/gltf/uri.h"

#include <algorithm>
#include <cstdint>

#include "host/base/lower_case.h"

namespace candela::gltf {
namespace {

constexpr std::string_view kDataScheme = "data:";
constexpr std::string_view kBase64Marker = ";base64";

std::optional<std::uint32_t> base64Digit(char c) {
  if (c >= 'A' && c <= 'Z') return static_cast<std::uint32_t>(c - 'A');
  if (c >= 'a' && c <= 'z') return static_cast<std::uint32_t>(c - 'a' + 26);
  if (c >= '0' && c <= '9') return static_cast<std::uint32_t>(c - '0' + 52);
  if (c == '+' || c == '-') return 62u;
  if (c == '/' || c == '_') return 63u;
  return std::nullopt;
}

std::optional<int> hexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return std::nullopt;
}

/// Letters, digits, + - . up to a colon, as in RFC 3986. One letter is a drive of Windows, and refused too.
bool hasScheme(std::string_view uri) {
  const std::size_t end = uri.find_first_of(":/?#");
  return end != std::string_view::npos && uri[end] == ':';
}

std::string decodeBase64(const Value& uri, std::string_view digits) {
  while (digits.ends_with('=')) digits.remove_suffix(1);
  if (digits.size() % 4 == 1) uri.fail("the data URI ends within a byte");
  std::string bytes;
  bytes.reserve(digits.size() / 4 * 3 + 3);
  std::uint32_t bits = 0;
  int pending = 0;
  for (const char c : digits) {
    const std::optional<std::uint32_t> digit = base64Digit(c);
    if (!digit) uri.fail("the data URI contains a character that is not base64");
    bits = bits << 6 | *digit;
    pending += 6;
    if (pending < 8) continue;
    pending -= 8;
    bytes += static_cast<char>(bits >> pending & 0xffu);
  }
  return bytes;
}

std::string decodePercent(const Value& uri, std::string_view text) {
  std::string bytes;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      bytes += text[i];
      continue;
    }
    const std::optional<int> high = i + 2 < text.size() ? hexDigit(text[i + 1]) : std::nullopt;
    const std::optional<int> low = i + 2 < text.size() ? hexDigit(text[i + 2]) : std::nullopt;
    if (!high || !low) uri.fail("\"%\" without two hexadecimal digits");
    bytes += static_cast<char>(*high * 16 + *low);
    i += 2;
  }
  return bytes;
}

}  // namespace

bool isDataUri(std::string_view uri) { return equalsIgnoringCase(uri.substr(0, kDataScheme.size()), kDataScheme); }

std::string decodeDataUri(const Value& uri) {
  const std::string_view whole = uri.text();
  const std::size_t comma = whole.find(',');
  if (comma == std::string_view::npos) uri.fail("the data URI has no comma");
  const std::string_view type = whole.substr(0, comma), data = whole.substr(comma + 1);
  const bool isBase64 = equalsIgnoringCase(type.substr(type.size() - std::min(type.size(), kBase64Marker.size())),
                                           kBase64Marker);
  if (!isBase64) return decodePercent(uri, data);
  const bool isEscaped = data.find('%') != std::string_view::npos;  // as URLSearchParams and encodeURIComponent() do
  return isEscaped ? decodeBase64(uri, decodePercent(uri, data)) : decodeBase64(uri, data);
}

std::filesystem::path decodePath(const Value& uri) {
  const std::string& text = uri.text();
  if (text.empty()) uri.fail("the URI is empty");
  if (hasScheme(text))
    uri.fail("only relative paths and data URIs are read; download the file and refer to it by path");
  const std::string path = decodePercent(uri, text);
  if (path.find('\0') != std::string::npos) uri.fail("the path contains a zero byte");
  return path;
}

}  // namespace candela::gltf
