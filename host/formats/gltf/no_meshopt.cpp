// Stands in for meshopt.cpp where meshoptimizer is not installed.
#include "host/formats/gltf/meshopt.h"

namespace candela::gltf {

bool canDecodeMeshopt() { return false; }

std::vector<std::byte> decodeMeshopt(const Value& extension, std::span<const std::byte>) {
  extension.fail("this program was built without meshoptimizer");
}

}  // namespace candela::gltf
