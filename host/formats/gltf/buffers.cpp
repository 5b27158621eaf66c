// Reads buffers and cuts views from them.
#include "host/formats/gltf/buffers.h"

#include <fmt/format.h>

#include "host/base/hash.h"
#include "host/formats/gltf/meshopt.h"
#include "host/formats/gltf/uri.h"
#include "host/formats/loading/read_file.h"

namespace candela::gltf {
namespace {

constexpr std::uint64_t kMinViewStride = 4;
constexpr std::uint64_t kMaxViewStride = 252;

Bytes asBytes(std::string_view text) { return std::as_bytes(std::span(text)); }

std::optional<std::size_t> strideOf(const Value& view) {
  const std::optional<Value> stride = view.find("byteStride");
  if (!stride) return std::nullopt;
  const std::uint64_t value = stride->whole();
  if (value < kMinViewStride || value > kMaxViewStride) {
    stride->fail(fmt::format("{} is outside {} to {}", value, kMinViewStride, kMaxViewStride));
  }
  return static_cast<std::size_t>(value);
}

}  // namespace

Buffers::Buffers(const Value& root, std::optional<std::string_view> binaryChunk, const scene::SceneFile& file,
                 const scene::LoadOptions& options)
    : root_(root), binaryChunk_(binaryChunk), file_(file), guard_(file.folder, options.allowedPaths) {}

BufferView Buffers::view(const Value& reference) {
  const std::size_t index = reference.indexInto("bufferViews", root_.sizeOf("bufferViews"));
  const Value view = root_.require("bufferViews")[index];
  const std::optional<Value> older = extensionOf(view, "EXT_meshopt_compression");
  const std::optional<Value> compression = older ? older : extensionOf(view, "KHR_meshopt_compression");
  if (!compression || !canDecodeMeshopt()) return plainView(view);
  const Bytes source = range(*compression, compression->wholeOr("byteOffset", 0),
                             compression->require("byteLength").whole());
  if (!decodedViews_.contains(index)) decodedViews_.emplace(index, decodeMeshopt(*compression, source));
  return {decodedViews_.at(index), static_cast<std::size_t>(compression->require("byteStride").whole())};
}

BufferView Buffers::plainView(const Value& view) {
  const std::optional<std::size_t> stride = strideOf(view);
  return {range(view, view.wholeOr("byteOffset", 0), view.require("byteLength").whole()), stride};
}

/// Offset and length are at most 2^53 each, so that their sum does not overflow.
Bytes Buffers::range(const Value& source, std::uint64_t offset, std::uint64_t length) {
  const Bytes all = buffer(source.require("buffer"));
  if (length == 0) source.require("byteLength").fail("a view of 0 bytes");
  if (offset + length > all.size()) {
    source.fail(fmt::format("bytes {} to {} of a buffer of {} bytes", offset, offset + length, all.size()));
  }
  return all.subspan(static_cast<std::size_t>(offset), static_cast<std::size_t>(length));
}

Bytes Buffers::buffer(const Value& reference) {
  const std::size_t index = reference.indexInto("buffers", root_.sizeOf("buffers"));
  const Value buffer = root_.require("buffers")[index];
  const std::uint64_t length = buffer.require("byteLength").whole();
  const bool isChunk = index == 0 && binaryChunk_ && !buffer.find("uri");
  if (!isChunk && !buffers_.contains(index)) buffers_.emplace(index, readBuffer(buffer));
  if (!isChunk && isCounting_) used_.insert(index);
  const Bytes bytes = asBytes(isChunk ? *binaryChunk_ : std::string_view(buffers_.at(index)));
  if (length > bytes.size()) {
    buffer.require("byteLength").fail(fmt::format("{} bytes are stated, but there are only {}", length, bytes.size()));
  }
  return bytes.first(static_cast<std::size_t>(length));
}

std::string Buffers::readBuffer(const Value& buffer) {
  const std::optional<Value> uri = buffer.find("uri");
  if (!uri) buffer.fail("the buffer has no \"uri\", and there is no binary chunk for it");
  return readUri(*uri);
}

std::string Buffers::readUri(const Value& uri) {
  if (isDataUri(uri.text())) return decodeDataUri(uri);
  try {
    const std::filesystem::path path = file_.folder / decodePath(uri);
    guard_.require(path);
    return scene::readFile(path);
  } catch (const JsonError&) {
    throw;
  } catch (const FileError& error) {
    uri.fail(error.what());
  }
}

std::uint64_t Buffers::hashFiles(std::uint64_t hash) const {
  for (const std::size_t index : used_) {
    const std::string& text = buffers_.at(index);
    hash = fnv1a({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, hash);
  }
  return hash;
}

}  // namespace candela::gltf
