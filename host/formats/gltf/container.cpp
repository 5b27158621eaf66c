// Splits GLB files into chunks (glTF 2.0 specification, section 4.4) and parses the JSON.
#include "host/formats/gltf/container.h"

#include <fmt/format.h>

#include <algorithm>

#include "host/base/json_text.h"
#include "host/base/quote.h"
#include "host/formats/gltf/value.h"

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

nlohmann::json jsonIn(const scene::SceneFile& file, std::string_view text) try {
  return parseJson(text);
} catch (const JsonSyntaxError& error) {
  const auto line = static_cast<std::uint32_t>(error.line);
  const auto column = static_cast<std::uint32_t>(error.column);
  throw scene::SceneError({{file.name, line, column, error.what()}});
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
  Container container{jsonIn(file, text), std::nullopt};
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
  return {jsonIn(file, withoutByteOrderMark(file.bytes)), std::nullopt};
}

}  // namespace candela::gltf
