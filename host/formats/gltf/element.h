// The types of an accessor's elements, and their conversion (glTF 2.0 specification, section 3.6.2).
#pragma once
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <type_traits>

#include "host/formats/gltf/buffers.h"

namespace candela::gltf {

enum class Component : std::uint16_t {
  signedByte = 5120,
  unsignedByte = 5121,
  signedShort = 5122,
  unsignedShort = 5123,
  unsignedInt = 5125,
  real = 5126
};

/// The number of elements and their type.
struct ElementType {
  std::size_t count = 0;
  Component component = Component::real;
  std::size_t components = 1;  ///< 1 for SCALAR, 2 to 4 for vectors, 4, 9 or 16 for matrices
  bool normalised = false;

  bool isUnsigned() const {
    return component == Component::unsignedByte || component == Component::unsignedShort ||
           component == Component::unsignedInt;
  }
};

std::size_t sizeOf(Component component);

/// Returns the component type of a number such as 5126. Throws JsonError.
Component componentOf(const Value& code);

/// The type of an accessor. Its count is 1 to 2^32 - 1. Throws JsonError.
ElementType elementTypeOf(const Value& accessor);

/// Returns the value of a normalised integer of type Raw, which is given as a float: -1 to 1 or 0 to 1.
template <class Raw, class Out>
Out normalise(Out value) {
  return std::max(value / static_cast<Out>(std::numeric_limits<Raw>::max()), Out{-1});
}

/// Returns the value of a component: section 3.6.2.2 of the specification.
template <class Out, class Raw>
Out convertComponent(Raw raw, bool normalised) {
  if constexpr (std::is_same_v<Out, Raw>) return raw;
  const auto value = static_cast<Out>(raw);
  if constexpr (std::is_floating_point_v<Out> && std::is_integral_v<Raw>) {
    return normalised ? normalise<Raw>(value) : value;
  }
  return value;
}

/// Calls `use(Raw{})` with a value of the C++ type of `component`.
template <class Use>
void withComponent(Component component, const Use& use) {
  switch (component) {
    case Component::signedByte:
      return use(std::int8_t{});
    case Component::unsignedByte:
      return use(std::uint8_t{});
    case Component::signedShort:
      return use(std::int16_t{});
    case Component::unsignedShort:
      return use(std::uint16_t{});
    case Component::unsignedInt:
      return use(std::uint32_t{});
    case Component::real:
      return use(float{});
  }
}

/// Normalises numbers that were stored as integers of the type, if it is normalised.
inline void normalise(const ElementType& type, std::span<float> numbers) {
  if (!type.normalised) return;
  withComponent(type.component, [&]<class Raw>(Raw) {
    for (float& number : numbers) number = normalise<Raw>(number);
  });
}

/// Converts all components of elements that begin `stride` bytes apart. `bytes` contains them all.
template <class Out>
void copyElements(const ElementType& type, Bytes bytes, std::size_t stride, std::span<Out> result) {
  withComponent(type.component, [&]<class Raw>(Raw raw) {
    for (std::size_t i = 0; i < type.count; ++i) {
      for (std::size_t c = 0; c < type.components; ++c) {
        std::memcpy(&raw, bytes.data() + i * stride + c * sizeof(Raw), sizeof(Raw));
        result[i * type.components + c] = convertComponent<Out>(raw, type.normalised);
      }
    }
  });
}

}  // namespace candela::gltf
