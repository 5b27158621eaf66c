// Reads vertices, faces and strips.
#include "host/formats/ply/ply_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "host/base/memory_budget.h"
#include "host/base/quote.h"
#include "host/formats/loading/polygon.h"
#include "host/formats/loading/vertex_normals.h"
#include "host/formats/ply/binary_values.h"
#include "host/formats/ply/ply_properties.h"
#include "host/formats/ply/text_values.h"
#include "host/image/colour_transfer.h"

namespace candela::ply {
namespace {

using scene::quote;

/// Colours of files are what a screen shows: encoded in sRGB, integers as fractions of the largest of their type.
class ColourDecoder {
 public:
  explicit ColourDecoder(NumberType type) : scale_(isInteger(type) ? static_cast<double>(maxOf(type)) : 1) {
    if (type != NumberType::uint8) return;
    for (int i = 0; i < 256; ++i) bytes_.push_back(decode(static_cast<float>(i)));
  }
  float operator()(float value) const {
    return bytes_.empty() ? decode(value) : bytes_[static_cast<std::size_t>(value)];
  }

 private:
  float decode(float value) const {
    return static_cast<float>(image::srgbDecode(std::clamp(static_cast<double>(value) / scale_, 0.0, 1.0)));
  }
  double scale_;
  std::vector<float> bytes_{};
};

float alphaOf(float value, NumberType type) {
  const double scale = isInteger(type) ? static_cast<double>(maxOf(type)) : 1;
  return static_cast<float>(std::clamp(static_cast<double>(value) / scale, 0.0, 1.0));
}

/// Reads the elements in their order. `Values` is TextValues or BinaryValues.
template <class Values>
class Body {
 public:
  Body(const scene::SceneFile& file, const Header& header, const Values& values, scene::DiagnosticLog& log)
      : file_(file), header_(header), values_(values), log_(log) {}

  Contents read() {
    const Element* const vertex = find("vertex");
    if (!vertex) fail("the file has no element \"vertex\"");
    const std::optional<VertexPlan> plan = planOf(*vertex);
    if (!plan) fail("the vertices have no positions: the properties x, y and z");
    plan_ = *plan;
    vertexCount_ = vertex->count;
    const Element* const face = find("face");
    const Element* const strip = find("tristrips");
    if ((!face || face->count == 0) && (!strip || strip->count == 0)) {
      fail("the file has no faces: it is a point cloud, which Candela does not render");
    }
    readElements();
    if (!values_.isAtEnd()) log_.warn("surplus", values_.position(), "what follows the last element is not read");
    scene::Mesh& mesh = contents_.mesh;
    if (mesh.indices.empty()) fail("no face has three vertices");
    if (!mesh.normals.empty()) scene::replaceZeroNormals(mesh);
    return std::move(contents_);
  }

 private:
  /// Faces that stand before the vertices are passed over, and read afterwards.
  void readElements() {
    std::vector<std::pair<const Element*, Values>> postponed;
    bool hasVertices = false;
    for (const Element& element : header_.elements) {
      const bool isFace = element.name == "face" || element.name == "tristrips";
      if (element.name == "vertex") {
        readVertices(element);
        hasVertices = true;
      } else if (isFace && hasVertices) {
        readFaces(element);
      } else {
        if (isFace) postponed.emplace_back(&element, values_);
        if (!isFace && element.count > 0) contents_.omissions.insert("element " + quote(element.name));
        pass(element);
      }
    }
    const Values end = values_;
    for (const auto& [element, values] : postponed) {
      values_ = values;
      readFaces(*element);
    }
    values_ = end;
  }

  void pass(const Element& element) {
    for (std::uint64_t row = 0; row < element.count; ++row) {
      values_.beginRow(element, row);
      for (const Property& property : element.properties) skip(property);
      values_.endRow();
    }
  }

  void skip(const Property& property) { values_.skip(property.type, property.countType ? lengthOf(property) : 1); }

  /// Reads the length of a list.
  std::uint64_t lengthOf(const Property& list) {
    const std::int64_t length = values_.integer(*list.countType);
    if (length < 0) values_.fail(fmt::format("the list {} has the length {}", quote(list.name), length));
    if (static_cast<std::uint64_t>(length) > values_.room(list.type)) {
      values_.fail(fmt::format("a list {} of {} numbers is longer than the file", quote(list.name), length));
    }
    return static_cast<std::uint64_t>(length);
  }

  void readVertices(const Element& vertex) {
    noteUse(vertex, [&](std::size_t i) { return plan_.slots[i] != kSlotCount; });
    reserve(vertex);
    ColourDecoder decode(typeIn(vertex, kRed));
    const NumberType alphaType = typeIn(vertex, kAlpha);
    std::array<float, kSlotCount + 1> numbers{};
    for (std::uint64_t row = 0; row < vertex.count; ++row) {
      values_.beginRow(vertex, row);
      for (std::size_t i = 0; i < plan_.slots.size(); ++i) {
        const Property& property = vertex.properties[i];
        const std::uint8_t slot = plan_.slots[i];
        if (slot == kSlotCount) {
          skip(property);
          continue;
        }
        numbers[slot] = values_.real(property.type);
        const bool isNormal = slot >= kNx && slot <= kNz;
        if (!isNormal && std::isnan(numbers[slot])) {
          values_.fail(fmt::format("{} is not a finite number of single precision", quote(property.name)));
        }
      }
      values_.endRow();
      addVertex(numbers, decode, alphaType);
    }
    contents_.counts["vertex"] = vertex.count;
  }

  void addVertex(const std::array<float, kSlotCount + 1>& n, const ColourDecoder& decode, NumberType alphaType) {
    scene::Mesh& mesh = contents_.mesh;
    mesh.positions.emplace_back(n[kX], n[kY], n[kZ]);
    if (plan_.hasNormals) {
      const glm::dvec3 normal(n[kNx], n[kNy], n[kNz]);
      mesh.normals.push_back(scene::unitNormalOrZero(normal));
    }
    if (plan_.hasTexCoords) mesh.texCoords[0].emplace_back(n[kS], n[kT]);
    if (!plan_.hasColours) return;
    const float alpha = plan_.hasAlpha ? alphaOf(n[kAlpha], alphaType) : 1;
    if (alpha < 1) contents_.hasTransparency = true;
    mesh.colours.emplace_back(decode(n[kRed]), decode(n[kGreen]), decode(n[kBlue]), alpha);
  }

  NumberType typeIn(const Element& vertex, Slot slot) const {
    const auto found = std::ranges::find(plan_.slots, slot) - plan_.slots.begin();
    return static_cast<std::size_t>(found) < plan_.slots.size()
               ? vertex.properties[static_cast<std::size_t>(found)].type
               : NumberType::uint8;
  }

  /// Reserves memory, after a check of what the vertices and the faces of the file need.
  void reserve(const Element& vertex) {
    scene::Mesh& mesh = contents_.mesh;
    const auto count = static_cast<std::size_t>(vertex.count);
    const std::size_t perVertex = sizeof(glm::vec3) * (plan_.hasNormals ? 2 : 1) +
                                  (plan_.hasTexCoords ? sizeof(glm::vec2) : 0) +
                                  (plan_.hasColours ? sizeof(glm::vec4) : 0);
    std::uint64_t faceCount = 0;
    for (const Element& element : header_.elements) faceCount += element.name == "face" ? element.count : 0;
    requireBytes(count * perVertex + 3 * faceCount * sizeof(std::uint32_t));
    mesh.positions.reserve(count);
    if (plan_.hasNormals) mesh.normals.reserve(count);
    if (plan_.hasTexCoords) mesh.texCoords[0].reserve(count);
    if (plan_.hasColours) mesh.colours.reserve(count);
  }

  void requireBytes(std::uint64_t bytes) const {
    requireMemory(file_.name + ": the scene", bytes, "use a machine with more memory");
  }

  /// Checks the memory of indices before more are added than was reserved.
  void requireRoom(std::uint64_t more) const {
    const std::vector<std::uint32_t>& indices = contents_.mesh.indices;
    if (indices.size() + more > indices.capacity()) requireBytes(2 * (indices.size() + more) * sizeof(std::uint32_t));
  }

  /// Reads an element "face" or "tristrips".
  void readFaces(const Element& element) {
    const bool isStrip = element.name == "tristrips";
    const std::optional<std::size_t> list = findIndexList(element);
    if (!list && element.count > 0) {
      fail(fmt::format("the element {} has no list \"vertex_indices\"", quote(element.name)));
    }
    noteUse(element, [&](std::size_t i) { return i == list; });
    if (!isStrip) contents_.mesh.indices.reserve(3 * static_cast<std::size_t>(element.count));
    for (std::uint64_t row = 0; row < element.count; ++row) {
      values_.beginRow(element, row);
      for (std::size_t i = 0; i < element.properties.size(); ++i) {
        if (i != list) {
          skip(element.properties[i]);
        } else if (isStrip) {
          readStrip(element.properties[i]);
        } else {
          readPolygon(element.properties[i]);
        }
      }
      values_.endRow();
    }
    contents_.counts[isStrip ? "strip" : "face"] = element.count;
  }

  std::uint32_t vertexAt(std::int64_t index) const {
    if (static_cast<std::uint64_t>(index) >= vertexCount_) failIndex(index);
    return static_cast<std::uint32_t>(index);
  }

  [[noreturn]] void failIndex(std::int64_t index) const {
    values_.fail(fmt::format("there is no vertex {}: the file has {}, counted from 0", index, vertexCount_));
  }

  void readPolygon(const Property& list) {
    const std::uint64_t length = lengthOf(list);
    std::vector<std::uint32_t>& indices = contents_.mesh.indices;
    if (length == 3) {
      values_.integers(list.type, 3, [&](std::int64_t index) { indices.push_back(vertexAt(index)); });
      return;
    }
    if (length > scene::kMaxPolygonVertices) {
      values_.fail(fmt::format("the face has {} vertices; at most {} are read", length, scene::kMaxPolygonVertices));
    }
    polygon_.clear();
    corners_.clear();
    values_.integers(list.type, length, [&](std::int64_t index) {
      polygon_.push_back(vertexAt(index));
      corners_.push_back(contents_.mesh.positions[polygon_.back()]);
    });
    if (length < 3) {
      log_.warn("small face", values_.position(), "a face of fewer than three vertices is not rendered");
      return;
    }
    requireRoom(3 * length);
    for (const auto& triangle : scene::triangulateWithWarnings(corners_, {}, log_).triangles) {
      for (const std::uint32_t corner : triangle) indices.push_back(polygon_[corner]);
    }
  }

  /// Every second triangle of a strip has the opposite order. An index of -1 begins another strip. Strips that continue
  /// elsewhere repeat vertices; triangles without area are left out.
  void readStrip(const Property& list) {
    std::vector<std::uint32_t>& indices = contents_.mesh.indices;
    const std::uint64_t length = lengthOf(list);
    requireRoom(3 * length);
    std::array<std::uint32_t, 2> last{};
    std::uint64_t inStrip = 0;
    for (std::uint64_t i = 0; i < length; ++i) {
      const std::int64_t index = values_.integer(list.type);
      if (index == -1 || index == std::numeric_limits<std::uint32_t>::max()) {
        inStrip = 0;
        continue;
      }
      const std::uint32_t vertex = vertexAt(index);
      const bool hasArea = vertex != last[0] && vertex != last[1] && last[0] != last[1];
      if (inStrip >= 2 && hasArea) {
        const bool isOdd = inStrip % 2 == 1;
        indices.insert(indices.end(), {last[isOdd ? 1 : 0], last[isOdd ? 0 : 1], vertex});
      }
      last = {last[1], vertex};
      ++inStrip;
    }
  }

  /// Notes the properties of an element that are not used.
  template <class IsUsed>
  void noteUse(const Element& element, const IsUsed& isUsed) {
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const Property& property = element.properties[i];
      if (isUsed(i)) continue;
      (isMeasurement(property) ? contents_.unused : contents_.omissions)
          .insert(fmt::format("{} of {}", quote(property.name), quote(element.name)));
    }
  }

  const Element* find(std::string_view name) const {
    const auto found = std::ranges::find(header_.elements, name, &Element::name);
    return found == header_.elements.end() ? nullptr : &*found;
  }

  [[noreturn]] void fail(const std::string& message) const { throw scene::SceneError({{file_.name, 0, 0, message}}); }

  const scene::SceneFile& file_;
  const Header& header_;
  Values values_;
  scene::DiagnosticLog& log_;
  VertexPlan plan_{};
  std::uint64_t vertexCount_ = 0;
  std::vector<std::uint32_t> polygon_{};  ///< indices of the vertices of the current face
  std::vector<glm::vec3> corners_{};      ///< their positions
  Contents contents_{};
};

template <class Values>
Contents readBody(const scene::SceneFile& file, const Header& header, const Values& values, scene::DiagnosticLog& log) {
  return Body<Values>(file, header, values, log).read();
}

}  // namespace

Contents readContents(const scene::SceneFile& file, const Header& header, bool lenient, scene::DiagnosticLog& log) {
  switch (header.encoding) {
    case Encoding::ascii:
      return readBody(file, header, TextValues(file, header, lenient, log), log);
    case Encoding::littleEndian:
      return readBody(file, header, BinaryValues<false>(file, header), log);
    case Encoding::bigEndian:
      return readBody(file, header, BinaryValues<true>(file, header), log);
  }
  throw InternalError("an encoding of PLY without a reader");
}

}  // namespace candela::ply
