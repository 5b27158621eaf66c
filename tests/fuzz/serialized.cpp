// The reader of Mitsuba's binary meshes: of a file, and of a mesh before it is deflated, which random changes of a file
// do not reach.
#include <zlib.h>

#include "host/formats/mitsuba/serialized_mesh.h"
#include "tests/fuzz/fuzz.h"

namespace candela::fuzz {
namespace {

/// A file of version 4 with one mesh.
std::string fileWith(Input mesh) {
  uLongf size = compressBound(mesh.size());
  std::string deflated(size, '\0');
  compress(reinterpret_cast<Bytef*>(deflated.data()), &size, mesh.data(), mesh.size());
  deflated.resize(size);
  return std::string("\x1c\x04\x04\0", 4) + deflated + std::string(8, '\0') + std::string("\x01\0\0\0", 4);
}

}  // namespace

void run(Input input) {
  for (const std::string& file : {textOf(input), fileWith(input)}) {
    for (const std::int64_t index : {0, 1}) {
      expectErrors([&] { mitsuba::readSerializedMesh("input", file, index, {.flipsTexCoords = true}); });
    }
  }
}

}  // namespace candela::fuzz
