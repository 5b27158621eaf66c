// Decodes buffer views by meshoptimizer. Conditions that its functions only assert are checked here first.
#include "host/formats/gltf/meshopt.h"

#include <fmt/format.h>
#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <string>

#include "host/base/quote.h"

namespace candela::gltf {
namespace {

constexpr std::uint64_t kMaxElementSize = 256;
/// A compressed vertex block takes at least a byte for each byte of a vertex and 256 vertices; an index buffer takes at
/// least a byte for each triangle. Larger counts are hostile.
constexpr std::uint64_t kMaxRatio = 4096;

struct Layout {
  std::uint64_t count;
  std::uint64_t stride;
  std::string mode;
  std::string filter;
};

void requireStride(const Value& extension, const Layout& layout) {
  const bool isAttributes = layout.mode == "ATTRIBUTES";
  const bool fits = isAttributes ? layout.stride % 4 == 0 && layout.stride > 0 && layout.stride <= kMaxElementSize
                                 : layout.stride == 2 || layout.stride == 4;
  const bool fitsFilter = layout.filter == "NONE" || layout.filter == "EXPONENTIAL" ||
                          (layout.filter == "OCTAHEDRAL" && (layout.stride == 4 || layout.stride == 8)) ||
                          (layout.filter == "QUATERNION" && layout.stride == 8);
  if (!fits || !fitsFilter) {
    extension.require("byteStride")
        .fail(fmt::format("{} does not fit mode {} and filter {}", layout.stride, scene::quote(layout.mode),
                          scene::quote(layout.filter)));
  }
  if (!isAttributes && layout.filter != "NONE") extension.require("filter").fail("only attributes have a filter");
}

/// KHR_meshopt_compression has another filter and another version of the stream of attributes, which
/// EXT_meshopt_compression lacks. Most files of either extension use neither.
void requireKnownFormat(const Value& extension, const Layout& layout, std::span<const std::byte> source) {
  constexpr std::byte kAttributesVersion1{0xa1};
  constexpr std::array kFilters{"NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL"};
  if (std::ranges::count(kFilters, layout.filter) == 0) {
    extension.require("filter").fail(scene::quote(layout.filter) +
                                     " is not NONE, OCTAHEDRAL, QUATERNION or EXPONENTIAL");
  }
  if (layout.mode == "ATTRIBUTES" && !source.empty() && source.front() == kAttributesVersion1) {
    extension.fail("attributes in version 1 of the compressed format are not supported; compress them in version 0");
  }
}

Layout layoutOf(const Value& extension, std::span<const std::byte> source) {
  const Layout layout{extension.require("count").whole(), extension.require("byteStride").whole(),
                      extension.require("mode").text(), extension.textOr("filter", "NONE")};
  if (layout.mode != "ATTRIBUTES" && layout.mode != "TRIANGLES" && layout.mode != "INDICES") {
    extension.require("mode").fail(scene::quote(layout.mode) + " is not ATTRIBUTES, TRIANGLES or INDICES");
  }
  requireKnownFormat(extension, layout, source);
  requireStride(extension, layout);
  if (layout.mode == "TRIANGLES" && layout.count % 3 != 0) {
    extension.require("count").fail("triangles need a multiple of 3 indices");
  }
  if (layout.count > source.size() * kMaxRatio) {
    extension.require("count").fail(fmt::format("{} elements cannot be in {} bytes", layout.count, source.size()));
  }
  return layout;
}

int decode(const Layout& layout, std::span<const std::byte> source, std::vector<std::byte>& result) {
  const auto* bytes = reinterpret_cast<const unsigned char*>(source.data());
  if (layout.mode == "ATTRIBUTES") {
    return meshopt_decodeVertexBuffer(result.data(), layout.count, layout.stride, bytes, source.size());
  }
  if (layout.mode == "TRIANGLES") {
    return meshopt_decodeIndexBuffer(result.data(), layout.count, layout.stride, bytes, source.size());
  }
  return meshopt_decodeIndexSequence(result.data(), layout.count, layout.stride, bytes, source.size());
}

void applyFilter(const Layout& layout, std::vector<std::byte>& result) {
  if (layout.filter == "OCTAHEDRAL") meshopt_decodeFilterOct(result.data(), layout.count, layout.stride);
  if (layout.filter == "QUATERNION") meshopt_decodeFilterQuat(result.data(), layout.count, layout.stride);
  if (layout.filter == "EXPONENTIAL") meshopt_decodeFilterExp(result.data(), layout.count, layout.stride);
}

}  // namespace

bool canDecodeMeshopt() { return true; }

std::vector<std::byte> decodeMeshopt(const Value& extension, std::span<const std::byte> source) {
  const Layout layout = layoutOf(extension, source);
  std::vector<std::byte> result(static_cast<std::size_t>(layout.count * layout.stride));
  if (layout.count == 0) return result;
  if (decode(layout, source, result) != 0) extension.fail("the compressed data is damaged");
  applyFilter(layout, result);
  return result;
}

}  // namespace candela::gltf
