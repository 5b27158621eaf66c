// Stands in for draco.cpp where Draco is not installed.
#include "host/formats/gltf/draco.h"

namespace candela::gltf {

bool canDecodeDraco() { return false; }

DracoMesh decodeDraco(const Value& extension, std::span<const std::byte>) {
  extension.fail("this program was built without Draco");
}

}  // namespace candela::gltf
