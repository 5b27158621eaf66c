// Splits GLB files into chunks (glTF 2.0 specification, section 4.4) and parses the JSON.
#include "host/gltf/container.h"

#include <fmt/format.h>

#include <algorithm>

#include "host/core/json_depth.h"
#include "host/gltf/value.h"
#include "host/scene/quote.h"

namespace candela::gltf {
namespace {

constexpr std::size_t kHeaderSize = 12;
constexpr std::size_t kChunkHeaderSize = 8;
constexpr std::uint32_t kChunkJson = 0x4e4f534a;
constexpr std::uint32_t kChunkBinary = 0x004e4942;

/// Little-endian.
std::uint32_t wordAt(std::string_view bytes, std::size_t offset) {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < 4; ++i) word |= std::uint32_t{static_cast<unsigned char>(bytes[offset + i])} << 8 * i;
  return word;
}

std::string_view withoutByteOrderMark(std::string_view text) {
  return text.starts_with("\xef\xbb\xbf") ? text.substr(3) : text;
}

[[noreturn]] void failAt(const scene::SceneFile& file, std::string_view text, std::size_t offset,
                         const std::string& message) {
  const std::string_view before = text.substr(0, std::min(offset, text.size()));
  const auto line = static_cast<std::uint32_t>(std::ranges::count(before, '\n') + 1);
  const auto column = static_cast<std::uint32_t>(before.size() - (before.rfind('\n') + 1) + 1);
  throw scene::SceneError({{file.name, line, column, message}});
}

/// Returns the part of nlohmann's message that describes the error, without "[...] parse error at line 1, column 2: ".
/// It quotes the file, whose bytes need not be text.
std::string reasonOf(const std::string& what) {
  const std::size_t start = what.find(": ");
  const std::string reason = start == std::string::npos ? what : what.substr(start + 2);
  constexpr std::size_t kMaxReason = 200;
  std::string shown;
  for (const char c : reason.substr(0, kMaxReason)) shown += c < 0x20 || c > 0x7e ? '?' : c;
  return shown;
}

/// The offset of a number that is too large for a double. nlohmann's message quotes it and lacks its place.
std::size_t offsetOfNumber(std::string_view text, std::string_view what) {
  const std::size_t end = what.rfind('\'');
  const std::size_t start = end == std::string_view::npos ? end : what.rfind('\'', end - 1);
  if (start == std::string_view::npos) return 0;
  const std::size_t offset = text.find(what.substr(start + 1, end - start - 1));
  return offset == std::string_view::npos ? 0 : offset;
}

nlohmann::json parseJson(const scene::SceneFile& file, std::string_view text) {
  if (const std::optional<std::size_t> deep = findTooDeepJson(text)) {
    failAt(file, text, *deep, fmt::format("JSON is nested more than {} levels deep", kMaxJsonDepth));
  }
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    failAt(file, text, error.byte > 0 ? error.byte - 1 : 0, "not valid JSON: " + reasonOf(error.what()));
  } catch (const nlohmann::json::exception& error) {
    failAt(file, text, offsetOfNumber(text, error.what()), "not valid JSON: number overflow");
  }
}

/// Returns the chunk at `offset`, and moves `offset` past it.
std::string_view takeChunk(std::string_view bytes, std::size_t& offset, std::uint32_t& type) {
  if (bytes.size() - offset < kChunkHeaderSize) {
    throw JsonError("GLB", fmt::format("the file ends within a chunk header at byte {}", offset));
  }
  const std::size_t length = wordAt(bytes, offset);
  type = wordAt(bytes, offset + 4);
  offset += kChunkHeaderSize;
  if (length > bytes.size() - offset) {
    throw JsonError("GLB", fmt::format("the chunk at byte {} has {} bytes, but the file ends after {}",
                                       offset - kChunkHeaderSize, length, bytes.size() - offset));
  }
  const std::string_view chunk = bytes.substr(offset, length);
  offset += length;
  return chunk;
}

Container readGlb(const scene::SceneFile& file) {
  if (file.bytes.size() < kHeaderSize) throw JsonError("GLB", "the file ends within the header of 12 bytes");
  const std::uint32_t version = wordAt(file.bytes, 4);
  if (version != 2) throw JsonError("GLB", fmt::format("container version {}; only version 2 is supported", version));
  const std::size_t length = wordAt(file.bytes, 8);
  if (length < kHeaderSize || length > file.bytes.size()) {
    throw JsonError("GLB", fmt::format("the header states {} bytes, but the file has {}", length, file.bytes.size()));
  }
  const std::string_view bytes = file.bytes.substr(0, length);
  std::size_t offset = kHeaderSize;
  std::uint32_t type = 0;
  const std::string_view text = takeChunk(bytes, offset, type);
  if (type != kChunkJson) throw JsonError("GLB", "the first chunk is not JSON");
  Container container{parseJson(file, text), std::nullopt};
  if (offset < bytes.size()) {
    const std::string_view second = takeChunk(bytes, offset, type);
    if (type == kChunkBinary) container.binary = second;
  }
  return container;
}

}  // namespace

bool looksLikeGltf(std::string_view bytes) {
  if (bytes.starts_with("glTF")) return true;
  const std::string_view text = withoutByteOrderMark(bytes);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && text[first] == '{';
}

Container readContainer(const scene::SceneFile& file) {
  if (file.bytes.starts_with("glTF")) return readGlb(file);
  return {parseJson(file, withoutByteOrderMark(file.bytes)), std::nullopt};
}

}  // namespace candela::gltf
