// The list of a scene's primitives, which stores consecutive ones that differ only in their index as one run.
#pragma once
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <span>
#include <vector>

#include "lists/primitive_kinds.h"

namespace candela::scene {

/// sphere, triangle, box, cone, plane: the entries of CANDELA_PRIMITIVE_KINDS, with their values.
enum class PrimitiveKind : std::uint8_t {
#define CANDELA_ENUMERATE_KIND(kind, feature, name, value, flag) kind = value,
  CANDELA_PRIMITIVE_KINDS(CANDELA_ENUMERATE_KIND)
#undef CANDELA_ENUMERATE_KIND
};

/// One entry of the scene's list of primitives. Its position in Scene::primitives is the *primitive index* that both
/// tracers report and that breaks ties between equal distances. Polygons, patches and emitting boxes are stored as
/// triangles.
struct Primitive {
  static constexpr std::uint32_t kMaxMeshes = 1u << 24;
  static constexpr std::uint32_t kUnplaced = 0xffffffffu;

  PrimitiveKind kind;
  std::uint32_t mesh : 24;  ///< of a triangle: into Scene::meshes; 0 otherwise
  std::uint32_t index;      ///< of a triangle: its index in its mesh; otherwise into the vector of the kind
  std::uint32_t material;   ///< into Scene::materials
  /// The index in Scene::placements for a triangle of an instance. Otherwise kUnplaced: the mesh has the vertices that
  /// are rendered.
  std::uint32_t placement = kUnplaced;

  Primitive(PrimitiveKind primitiveKind, std::uint32_t shapeIndex, std::uint32_t materialIndex,
            std::uint32_t meshIndex = 0, std::uint32_t placementIndex = kUnplaced)
      : kind(primitiveKind),
        mesh(meshIndex & (kMaxMeshes - 1)),
        index(shapeIndex),
        material(materialIndex),
        placement(placementIndex) {}

  bool isPlaced() const { return placement != kUnplaced; }
  bool operator==(const Primitive&) const = default;
};
static_assert(sizeof(Primitive) == 16);

/// Primitives whose members are those of `start`, apart from their indices, which follow each other. An instance is a
/// run with a placement.
struct PrimitiveRun {
  std::uint32_t first;  ///< primitive index of `start`
  Primitive start;

  Primitive at(std::uint32_t primitive) const {
    Primitive result = start;
    result.index += primitive - first;
    return result;
  }
  bool operator==(const PrimitiveRun&) const = default;
};

/// A sequence of primitives. Reading one by its index takes O(log runs), iterating over all of them O(1) each.
class PrimitiveList {
 public:
  class Iterator;
  using value_type = Primitive;
  /// Devices and films use the two highest 32-bit numbers for other purposes than primitive indices.
  static constexpr std::uint32_t kMaxSize = 0xfffffffeu;

  PrimitiveList() = default;
  PrimitiveList(std::initializer_list<Primitive> primitives) : PrimitiveList(std::span(primitives)) {}
  explicit PrimitiveList(std::span<const Primitive> primitives);

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  Primitive operator[](std::size_t index) const { return runOf(index).at(static_cast<std::uint32_t>(index)); }
  Primitive back() const { return (*this)[size_ - 1]; }
  Iterator begin() const;
  Iterator end() const;

  /// The runs in the order of their primitives.
  std::span<const PrimitiveRun> runs() const { return runs_; }
  /// Returns the run to which a primitive, which must exist, belongs.
  const PrimitiveRun& runOf(std::size_t primitive) const;
  /// Returns the number of primitives of a run.
  std::uint32_t countOf(const PrimitiveRun& run) const;

  void push_back(const Primitive& primitive) { append(primitive, 1); }
  /// Appends primitives that differ from `start` in their indices, which follow each other.
  void append(const Primitive& start, std::uint32_t count);
  void clear() { *this = {}; }

  bool operator==(const PrimitiveList&) const;

 private:
  std::vector<PrimitiveRun> runs_;
  std::uint32_t size_ = 0;
};

class PrimitiveList::Iterator {
 public:
  using iterator_concept = std::forward_iterator_tag;
  using iterator_category = std::input_iterator_tag;
  using value_type = Primitive;
  using difference_type = std::ptrdiff_t;
  using reference = Primitive;
  using pointer = void;

  Iterator() = default;
  Iterator(const PrimitiveList& list, std::uint32_t index)
      : runs_(list.runs_), run_(index == 0 ? 0 : list.runs_.size()), index_(index) {}

  Primitive operator*() const { return runs_[run_].at(index_); }
  Iterator& operator++() {
    ++index_;
    if (run_ + 1 < runs_.size() && runs_[run_ + 1].first == index_) ++run_;
    return *this;
  }
  Iterator operator++(int) {
    Iterator before = *this;
    ++*this;
    return before;
  }
  bool operator==(const Iterator& other) const { return index_ == other.index_; }

 private:
  std::span<const PrimitiveRun> runs_;
  std::size_t run_ = 0;
  std::uint32_t index_ = 0;
};

inline PrimitiveList::Iterator PrimitiveList::begin() const { return {*this, 0}; }
inline PrimitiveList::Iterator PrimitiveList::end() const { return {*this, size_}; }

}  // namespace candela::scene
