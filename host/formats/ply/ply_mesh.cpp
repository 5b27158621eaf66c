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
/// Floats may be linear instead.
class ColourDecoder {
 public:
  ColourDecoder(NumberType type, bool hasLinearFloats)
      : scale_(isInteger(type) ? static_cast<double>(maxOf(type)) : 1), isLinear_(hasLinearFloats && !isInteger(type)) {
    if (type != NumberType::uint8) return;
    for (int i = 0; i < 256; ++i) bytes_.push_back(decode(static_cast<float>(i)));
  }
  float operator()(float value) const {
    return bytes_.empty() ? decode(value) : bytes_[static_cast<std::size_t>(value)];
  }

 private:
  float decode(float value) const {
    const double signal = std::clamp(static_cast<double>(value) / scale_, 0.0, 1.0);
    return static_cast<float>(isLinear_ ? signal : image::srgbDecode(signal));
  }
  double scale_;
  bool isLinear_;
  std::vector<float> bytes_{};
};

/// The numbers of a row, by slot.
using Numbers = std::array<float, kSlotCount + 1>;

/// Makes the colours of the rows of an element.
class ColourReader {
 public:
  ColourReader(const VertexPlan& plan, const Element& element, const ColourSource& source)
      : decode_(typeIn(plan, element, kRed), source.isLinear), isGrey_(plan.isGrey), hasAlpha_(plan.hasAlpha) {
    const NumberType type = typeIn(plan, element, kAlpha);
    alphaScale_ = isInteger(type) ? static_cast<double>(maxOf(type)) : 1;
  }
  glm::vec4 operator()(const Numbers& n) const {
    const double alpha = hasAlpha_ ? static_cast<double>(n[kAlpha]) / alphaScale_ : 1;
    return {decode_(n[kRed]), decode_(n[isGrey_ ? kRed : kGreen]), decode_(n[isGrey_ ? kRed : kBlue]),
            static_cast<float>(std::clamp(alpha, 0.0, 1.0))};
  }

 private:
  static NumberType typeIn(const VertexPlan& plan, const Element& element, Slot slot) {
    const auto found = static_cast<std::size_t>(std::ranges::find(plan.slots, slot) - plan.slots.begin());
    return found < plan.slots.size() ? element.properties[found].type : NumberType::uint8;
  }

  ColourDecoder decode_;
  bool isGrey_, hasAlpha_;
  double alphaScale_;
};

/// Reads the elements in their order. `Values` is TextValues or BinaryValues.
template <class Values>
class Body {
 public:
  Body(const scene::SceneFile& file, const Header& header, const ColourSource& source, const Values& values,
       scene::DiagnosticLog& log)
      : file_(file), header_(header), source_(source), values_(values), log_(log) {}

  Contents read() {
    const Element* const vertex = find("vertex");
    if (!vertex) fail("the file has no element \"vertex\"");
    const std::optional<VertexPlan> plan = planOf(*vertex, source_.isOfFaces ? "" : source_.name);
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
    const ColourReader colourOf(plan_, vertex, source_);
    Numbers numbers{};
    for (std::uint64_t row = 0; row < vertex.count; ++row) {
      values_.beginRow(vertex, row);
      for (std::size_t i = 0; i < plan_.slots.size(); ++i) read(vertex.properties[i], plan_.slots[i], numbers);
      values_.endRow();
      addVertex(numbers, colourOf);
    }
    contents_.counts["vertex"] = vertex.count;
  }

  /// Reads the number of a slot, or passes over a property without one.
  void read(const Property& property, std::uint8_t slot, Numbers& numbers) {
    if (slot == kSlotCount) {
      skip(property);
      return;
    }
    numbers[slot] = values_.real(property.type);
    const bool isNormal = slot >= kNx && slot <= kNz;
    if (!isNormal && std::isnan(numbers[slot])) {
      values_.fail(fmt::format("{} is not a finite number of single precision", quote(property.name)));
    }
  }

  void addVertex(const Numbers& n, const ColourReader& colourOf) {
    scene::Mesh& mesh = contents_.mesh;
    mesh.positions.emplace_back(n[kX], n[kY], n[kZ]);
    if (plan_.hasNormals) {
      const glm::dvec3 normal(n[kNx], n[kNy], n[kNz]);
      mesh.normals.push_back(scene::unitNormalOrZero(normal));
    }
    if (plan_.hasTexCoords) mesh.texCoords[0].emplace_back(n[kS], n[kT]);
    if (!plan_.hasColours) return;
    mesh.colours.push_back(colourOf(n));
    if (mesh.colours.back().w < 1) contents_.hasTransparency = true;
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
    const VertexPlan plan = facePlanOf(element, source_.isOfFaces ? source_.name : "");
    const ColourReader colourOf(plan, element, source_);
    noteUse(element, [&](std::size_t i) { return i == list || plan.slots[i] != kSlotCount; });
    if (!isStrip) contents_.mesh.indices.reserve(3 * static_cast<std::size_t>(element.count));
    if (plan.hasColours) requireBytes(element.count * sizeof(glm::vec4));
    Numbers numbers{};
    for (std::uint64_t row = 0; row < element.count; ++row) {
      values_.beginRow(element, row);
      for (std::size_t i = 0; i < element.properties.size(); ++i) {
        if (i != list) {
          read(element.properties[i], plan.slots[i], numbers);
        } else if (isStrip) {
          readStrip(element.properties[i]);
        } else {
          readPolygon(element.properties[i]);
        }
      }
      values_.endRow();
      if (plan.hasColours) contents_.faceColours.resize(contents_.mesh.indices.size() / 3, colourOf(numbers));
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
  const ColourSource& source_;
  Values values_;
  scene::DiagnosticLog& log_;
  VertexPlan plan_{};
  std::uint64_t vertexCount_ = 0;
  std::vector<std::uint32_t> polygon_{};  ///< indices of the vertices of the current face
  std::vector<glm::vec3> corners_{};      ///< their positions
  Contents contents_{};
};

template <class Values>
Contents readBody(const scene::SceneFile& file, const Header& header, const ColourSource& source, const Values& values,
                  scene::DiagnosticLog& log) {
  return Body<Values>(file, header, source, values, log).read();
}

}  // namespace

Contents readContents(const scene::SceneFile& file, const Header& header, const ColourSource& source, bool lenient,
                      scene::DiagnosticLog& log) {
  switch (header.encoding) {
    case Encoding::ascii:
      return readBody(file, header, source, TextValues(file, header, lenient, log), log);
    case Encoding::littleEndian:
      return readBody(file, header, source, BinaryValues<false>(file, header), log);
    case Encoding::bigEndian:
      return readBody(file, header, source, BinaryValues<true>(file, header), log);
  }
  throw InternalError("an encoding of PLY without a reader");
}

}  // namespace candela::ply
