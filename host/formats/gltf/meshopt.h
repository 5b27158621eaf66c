// EXT_meshopt_compression and KHR_meshopt_compression: buffer views that meshoptimizer has compressed.
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "host/formats/gltf/value.h"

namespace candela::gltf {

/// Returns whether this program was built with meshoptimizer.
bool canDecodeMeshopt();

/// `extension` is the extension's object, `source` the bytes that it refers to. The result has byteStride times count
/// bytes. Throws JsonError for values that the extension does not allow, and for damaged data.
std::vector<std::byte> decodeMeshopt(const Value& extension, std::span<const std::byte> source);

}  // namespace candela::gltf
