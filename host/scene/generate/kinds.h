// The kinds of scenes that can be generated.
#pragma once
#include <cstdint>
#include <span>
#include <string_view>

#include "host/scene/generate/nff_writer.h"

namespace candela::generate {

/// Maximum number of primitives that a file stores, so that every scene fits into a file that can be read (1 GiB).
inline constexpr std::uint64_t kMaxPrimitives = 6'000'000;

struct Kind {
  std::string_view name;
  std::string_view summary;  ///< no capital, no full stop
  std::uint32_t minSize;
  std::uint32_t defaultSize;
  std::uint64_t (*primitiveCount)(std::uint32_t size);  ///< number of primitives as traced; grows with size
  void (*write)(NffWriter& out, std::uint32_t size);
  bool isGltf = false;  ///< the scene is written as glTF (JSON), else as NFF
  /// Maximum size of a kind with instances, whose file grows by one instance for each step of the size; 0: a kind whose
  /// file stores all of its primitives.
  std::uint32_t maxInstances = 0;

  /// Returns the maximum size: `maxInstances`, else the one with at most kMaxPrimitives primitives.
  std::uint32_t maxSize() const;
};

std::span<const Kind> kindTable();

/// Writes the scene as text, in blocks. `size` is in the range of the kind.
void generateScene(const Kind& kind, std::uint32_t size, NffWriter::Sink sink);

}  // namespace candela::generate
