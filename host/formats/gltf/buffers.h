// The buffers of a glTF file and the views into them, read when they are first requested.
#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "host/formats/gltf/container.h"
#include "host/formats/gltf/value.h"
#include "host/formats/loading/path_guard.h"

namespace candela::gltf {

using Bytes = std::span<const std::byte>;

/// The bytes of a buffer view. They live as long as the Buffers.
struct BufferView {
  Bytes bytes;
  std::optional<std::size_t> stride;  ///< from one element to the next; none: elements follow each other
};

/// Reads buffers from the file itself, from data URIs and from other files that the guard permits. Compressed views
/// (EXT_meshopt_compression) are decoded.
class Buffers {
 public:
  /// `root`, `binaryChunk` and `file` must outlive this object.
  Buffers(const Value& root, std::optional<std::string_view> binaryChunk, const scene::SceneFile& file,
          const scene::LoadOptions& options);

  /// The view that a property like `bufferView` refers to. Throws JsonError, at the place of the error, if the view
  /// or its buffer does not fit or cannot be read.
  BufferView view(const Value& reference);

  /// The bytes of a data URI, or of a file that the guard permits. Throws JsonError at the URI.
  std::string readUri(const Value& uri);

  /// The other files that readUri() was to read.
  const std::vector<std::filesystem::path>& files() const { return guard_.requiredPaths(); }

  /// Buffers that are used from here on, until endScene(), are those that hashFiles() describes. The bytes of all stay.
  void beginScene() {
    used_.clear();
    isCounting_ = true;
  }
  void endScene() { isCounting_ = false; }
  /// The 64-bit FNV-1a hash of all buffers from other files and data URIs that were used, continued from `hash`, in the
  /// order of the buffers.
  std::uint64_t hashFiles(std::uint64_t hash) const;

 private:
  Bytes buffer(const Value& reference);
  std::string readBuffer(const Value& buffer);
  BufferView plainView(const Value& view);
  Bytes range(const Value& source, std::uint64_t offset, std::uint64_t length);

  Value root_;
  std::optional<std::string_view> binaryChunk_;
  const scene::SceneFile& file_;
  scene::PathGuard guard_;
  std::map<std::size_t, std::string> buffers_;                    ///< by index; decoded or read
  std::set<std::size_t> used_{};                                  ///< indices in `buffers_`
  bool isCounting_ = true;                                        ///< buffers become used
  std::map<std::size_t, std::vector<std::byte>> decodedViews_{};  ///< by index; EXT_meshopt_compression
};

}  // namespace candela::gltf
