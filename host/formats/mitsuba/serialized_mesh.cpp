// Inflates and reads the arrays of a mesh.
#include "host/formats/mitsuba/serialized_mesh.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "host/base/errors.h"
#include "host/base/memory_budget.h"
#include "host/base/quote.h"
#include "host/formats/loading/vertex_normals.h"

namespace candela::mitsuba {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers of the file are copied");

constexpr std::uint16_t kMagic = 0x041c;
constexpr std::uint64_t kMaxRatio = 1032;  // of deflated data to their size

enum Flags : std::uint32_t { kNormals = 0x1, kTexCoords = 0x2, kColours = 0x8, kDouble = 0x2000 };

template <class Number>
Number numberAt(std::string_view bytes, std::size_t offset) {
  Number number;
  std::memcpy(&number, bytes.data() + offset, sizeof(Number));
  return number;
}

/// Inflates a stream of zlib, part by part.
class Inflater {
 public:
  Inflater(std::string file, std::string_view bytes) : file_(std::move(file)) {
    stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream_.avail_in = static_cast<uInt>(bytes.size());  // at most 1 GiB
    if (inflateInit(&stream_) != Z_OK) throw FileError(file_ + ": zlib cannot be used");
  }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;
  ~Inflater() { inflateEnd(&stream_); }

  void read(void* data, std::size_t size) {
    auto* next = static_cast<Bytef*>(data);
    while (size > 0) {
      const auto part = static_cast<uInt>(std::min(size, std::size_t{1} << 30));
      stream_.next_out = next;
      stream_.avail_out = part;
      const int status = inflate(&stream_, Z_NO_FLUSH);
      const std::size_t count = part - stream_.avail_out;
      if (count == 0 || (status != Z_OK && status != Z_STREAM_END))
        throw FileError(file_ + ": the data of the mesh end too early, or are damaged");
      next += count;
      size -= count;
    }
  }
  template <class Number>
  Number number() {
    Number value{};
    read(&value, sizeof(value));
    return value;
  }
  /// Passes over a text that ends with a byte 0.
  void passText() {
    constexpr int kMaxLength = 4096;
    for (int i = 0; i < kMaxLength; ++i) {
      if (number<char>() == 0) return;
    }
    throw FileError(file_ + ": the name of the mesh does not end");
  }
  /// Returns the largest number of bytes that may still come.
  std::uint64_t room() const { return kMaxRatio * (std::uint64_t{stream_.avail_in} + 64); }

 private:
  std::string file_;
  z_stream stream_{};
};

/// Returns the part of the file with the stream of a mesh. The offsets of all are at the end, followed by their number.
std::string_view streamOf(std::string_view bytes, std::int64_t index, const std::string& name) {
  constexpr std::size_t kHead = 4;  // magic number and version, which stand before each stream
  if (bytes.size() < kHead + sizeof(std::uint32_t) || numberAt<std::uint16_t>(bytes, 0) != kMagic) {
    throw FileError(name + " is not a serialized mesh");
  }
  const auto version = numberAt<std::uint16_t>(bytes, 2);
  if (version != 3 && version != 4)
    throw FileError(fmt::format("{}: serialized meshes of version {} are not read", name, version));
  const std::size_t tableEnd = bytes.size() - sizeof(std::uint32_t);
  const auto count = numberAt<std::uint32_t>(bytes, tableEnd);
  const std::size_t width = version == 4 ? sizeof(std::uint64_t) : sizeof(std::uint32_t);
  if (index < 0 || index >= count || count > tableEnd / width) {
    throw FileError(fmt::format("{}: there is no mesh {}: the file has {}, counted from 0", name, index, count));
  }
  const std::size_t entry = tableEnd - width * (count - static_cast<std::size_t>(index));
  const std::uint64_t offset = version == 4 ? numberAt<std::uint64_t>(bytes, entry)
                                            : numberAt<std::uint32_t>(bytes, entry);
  if (offset > bytes.size() - kHead) throw FileError(name + ": a mesh begins after the end of the file");
  return bytes.substr(static_cast<std::size_t>(offset) + kHead);
}

/// Reads vectors of single or double precision.
template <class Vector>
std::vector<Vector> vectorsOf(Inflater& inflater, std::size_t count, bool isDouble, const std::string& name) {
  std::vector<Vector> vectors(count);
  if (!isDouble) {
    inflater.read(vectors.data(), count * sizeof(Vector));
  } else {
    for (Vector& vector : vectors) {
      for (glm::length_t c = 0; c < Vector::length(); ++c) vector[c] = static_cast<float>(inflater.number<double>());
    }
  }
  for (const Vector& vector : vectors) {
    for (glm::length_t c = 0; c < Vector::length(); ++c) {
      if (!std::isfinite(vector[c])) throw FileError(name + ": a number is not finite in single precision");
    }
  }
  return vectors;
}

void checkIndices(const std::vector<std::uint32_t>& indices, std::uint64_t vertexCount, const std::string& name) {
  for (const std::uint32_t index : indices) {
    if (index >= vertexCount)
      throw FileError(
          fmt::format("{}: there is no vertex {}: the mesh has {}, counted from 0", name, index, vertexCount));
  }
}

}  // namespace

scene::Mesh readSerializedMesh(const std::filesystem::path& path, std::string_view bytes, std::int64_t index,
                               const MeshFileOptions& options) {
  const std::string name = scene::quote(path.filename().string());
  Inflater inflater(name, streamOf(bytes, index, name));
  const auto flags = inflater.number<std::uint32_t>();
  const bool hasName = numberAt<std::uint16_t>(bytes, 2) == 4;
  if (hasName) inflater.passText();
  const auto vertexCount = inflater.number<std::uint64_t>(), triangleCount = inflater.number<std::uint64_t>();
  const bool isDouble = (flags & kDouble) != 0;
  const std::uint64_t perVertex = (3 + ((flags & kNormals) != 0 ? 3 : 0) + ((flags & kTexCoords) != 0 ? 2 : 0) +
                                   ((flags & kColours) != 0 ? 3 : 0)) *
                                  (isDouble ? sizeof(double) : sizeof(float));
  const std::uint64_t room = inflater.room(), perTriangle = 3 * sizeof(std::uint32_t);
  const bool fits = vertexCount <= room / perVertex && triangleCount <= room / perTriangle &&
                    vertexCount <= std::numeric_limits<std::uint32_t>::max();
  if (!fits)
    throw FileError(fmt::format("{}: {} vertices and {} triangles are more than the file can contain", name,
                                vertexCount, triangleCount));
  if (triangleCount == 0) throw FileError(name + " has no triangles");
  requireMemory(name + ": the mesh", vertexCount * 2 * perVertex + triangleCount * perTriangle,
                "use a machine with more memory");
  const auto count = static_cast<std::size_t>(vertexCount);
  scene::Mesh mesh;
  mesh.positions = vectorsOf<glm::vec3>(inflater, count, isDouble, name);
  if ((flags & kNormals) != 0) mesh.normals = vectorsOf<glm::vec3>(inflater, count, isDouble, name);
  if ((flags & kTexCoords) != 0) mesh.texCoords[0] = vectorsOf<glm::vec2>(inflater, count, isDouble, name);
  if ((flags & kColours) != 0) vectorsOf<glm::vec3>(inflater, count, isDouble, name);
  mesh.indices.resize(static_cast<std::size_t>(3 * triangleCount));
  inflater.read(mesh.indices.data(), mesh.indices.size() * sizeof(std::uint32_t));
  checkIndices(mesh.indices, vertexCount, name);
  for (glm::vec3& normal : mesh.normals) normal = scene::unitNormalOrZero(glm::dvec3(normal));
  complete(mesh, options);
  return mesh;
}

}  // namespace candela::mitsuba
