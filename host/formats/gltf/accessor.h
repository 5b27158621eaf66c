// Accessors: typed elements in buffer views (glTF 2.0 specification, section 3.6.2).
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "host/formats/gltf/element.h"
#include "host/formats/gltf/stored_values.h"
#include "host/formats/loading/diagnostic_log.h"

namespace candela::gltf {

/// How elements with a component that is not finite are read: as an error, or as 0 with a warning.
enum class NonFinite : std::uint8_t { refused, zero };

/// Every offset, stride and count is checked before a byte is read. All functions take the reference to an accessor,
/// such as `indices`, and throw JsonError at the accessor's own place if it is wrong, or at the reference if the
/// accessor is not of the type that is needed there. Elements that exceed the memory budget throw OutOfMemoryError.
/// Elements without a buffer view take no bytes in the file, whose size limits all others. At most 2^24 of them are
/// read from a file, and 1024 more for each element that was read from a buffer view: those of sparse morph targets.
class Accessors {
 public:
  /// All must outlive this object. `lenientLog` receives the warnings of NonFinite::zero; without it, such elements are
  /// errors, whose messages name --lenient.
  Accessors(const Value& root, Buffers& buffers, scene::DiagnosticLog* lenientLog = nullptr)
      : root_(root), buffers_(buffers), lenientLog_(lenientLog) {}

  /// Without reading elements.
  ElementType type(const Value& reference) const;
  /// Number of elements, once it is certain that they are in their buffer view, or may be read without one.
  std::size_t count(const Value& reference);

  /// Elements with as many components as Vector has, or floats for SCALAR. Normalised integers are converted to
  /// their values (-1 to 1 or 0 to 1), other integers are not changed. All results are finite, as `nonFinite` tells.
  ///
  /// With a selection, only these elements are returned, which must exist. The accessor is read and checked as a whole
  /// the first time only, so that many primitives may select a few elements each from one large accessor.
  template <class Vector>
  std::vector<Vector> read(const Value& reference, const Selection& selection = {},
                           NonFinite nonFinite = NonFinite::refused);
  /// SCALAR or vectors of unsigned integers that are not normalised, all components in sequence.
  std::vector<std::uint32_t> readWhole(const Value& reference, std::size_t components, const Selection& selection = {});

 private:
  static constexpr std::size_t kMaxStoredValues = std::size_t{1} << 26;

  struct Elements {
    Value source;
    ElementType type;
    Bytes bytes;  ///< from the first element on; empty: all elements are 0
    std::size_t stride;
  };
  std::size_t indexOf(const Value& reference) const;
  Value accessorOf(const Value& reference) const;
  Elements elementsOf(const Value& reference, std::size_t components);
  Elements inView(const Value& source, const ElementType& type);
  /// The elements of an accessor, all 0 without a buffer view, apart from sparse ones.
  Elements elementsIn(const Value& accessor, const ElementType& type);
  void readReals(const Elements& elements, NonFinite nonFinite, std::span<float> result);
  std::vector<std::uint32_t> readAllWhole(const Value& reference, std::size_t components);
  /// All components of an accessor. They are valid until the next call.
  std::span<const float> storedReals(const Value& reference, std::size_t components, NonFinite nonFinite);
  template <class Out>
  void applySparse(const Value& accessor, const ElementType& type, std::span<Out> result);

  Value root_;
  Buffers& buffers_;
  scene::DiagnosticLog* lenientLog_;
  std::uint64_t readCount_ = 0;  ///< elements of buffer views
  std::uint64_t zeroCount_ = 0;  ///< elements without a buffer view
  StoredValues<float> reals_{kMaxStoredValues};
  StoredValues<std::uint32_t> wholes_{kMaxStoredValues};
};

template <class Vector>
std::vector<Vector> Accessors::read(const Value& reference, const Selection& selection, NonFinite nonFinite) {
  constexpr std::size_t kComponents = sizeof(Vector) / sizeof(float);
  const auto numbersOf = [](std::vector<Vector>& vectors) {
    return std::span(reinterpret_cast<float*>(vectors.data()), vectors.size() * kComponents);
  };
  if (selection) {
    std::vector<Vector> result(selection->size());
    gather(storedReals(reference, kComponents, nonFinite), kComponents, *selection, numbersOf(result));
    return result;
  }
  const Elements elements = elementsOf(reference, kComponents);
  std::vector<Vector> result(elements.type.count);
  readReals(elements, nonFinite, numbersOf(result));
  return result;
}

}  // namespace candela::gltf
