// The types of an accessor's elements.
#include "host/formats/gltf/element.h"

#include <fmt/format.h>

#include <array>

#include "host/base/quote.h"

namespace candela::gltf {
namespace {

constexpr std::uint64_t kMaxCount = 0xffffffffu;

struct TypeName {
  std::string_view name;
  std::size_t components;
};
constexpr std::array kTypeNames{TypeName{"SCALAR", 1}, TypeName{"VEC2", 2}, TypeName{"VEC3", 3}, TypeName{"VEC4", 4},
                                TypeName{"MAT2", 4},   TypeName{"MAT3", 9}, TypeName{"MAT4", 16}};

TypeName typeNameOf(const Value& name) {
  const auto* const found = std::ranges::find(kTypeNames, name.text(), &TypeName::name);
  if (found == kTypeNames.end()) name.fail(scene::quote(name.text()) + " is not a type of elements");
  return *found;
}

}  // namespace

std::size_t sizeOf(Component component) {
  if (component == Component::signedByte || component == Component::unsignedByte) return 1;
  return component == Component::signedShort || component == Component::unsignedShort ? 2 : 4;
}

Component componentOf(const Value& code) {
  const std::uint64_t value = code.whole();
  for (const Component component : {Component::signedByte, Component::unsignedByte, Component::signedShort,
                                    Component::unsignedShort, Component::unsignedInt, Component::real}) {
    if (value == static_cast<std::uint64_t>(component)) return component;
  }
  code.fail(fmt::format("{} is not a component type (5120 to 5123, 5125 or 5126)", value));
}

ElementType elementTypeOf(const Value& accessor) {
  const std::uint64_t count = accessor.require("count").whole();
  if (count == 0 || count > kMaxCount) accessor.require("count").fail(fmt::format("{} elements", count));
  const TypeName name = typeNameOf(accessor.require("type"));
  ElementType type{static_cast<std::size_t>(count), componentOf(accessor.require("componentType")), name.components,
                   accessor.booleanOr("normalized", false)};
  const bool isInteger = type.component != Component::real && type.component != Component::unsignedInt;
  if (type.normalised && !isInteger) accessor.require("normalized").fail("only bytes and shorts can be normalised");
  // The columns of matrices of bytes and shorts are padded. glTF does not use such matrices.
  if (name.name.starts_with("MAT") && type.component != Component::real) {
    accessor.require("componentType").fail("matrices of integers are not supported");
  }
  return type;
}

}  // namespace candela::gltf
