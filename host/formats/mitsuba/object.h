// The objects of a scene with their properties, as the file states them.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <initializer_list>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "host/formats/mitsuba/document.h"

namespace candela::mitsuba {

class Object;

/// A colour in linear RGB: <rgb>.
struct Rgb {
  glm::dvec3 colour;
};

/// A spectrum: <spectrum> without a type. Values between the wavelengths are interpolated, and 0 beyond them.
struct Samples {
  std::vector<std::pair<double, double>> values{};  ///< wavelength in nm, rising, and value; one alone: at all of them
};

/// A reference that is not resolved yet: <ref>.
struct Reference {
  std::string id;
};

using Value = std::variant<bool, std::int64_t, double, std::string, glm::dvec3, Rgb, Samples, glm::dmat4, Reference,
                           const Object*>;

struct Property {
  std::string name;  ///< empty: the element has none, as nested objects do
  Value value;
  Place place{};
};

/// An element such as <bsdf>, with its properties. The functions that return a value mark its property as used. Those
/// with a default return it if there is no such property. All throw PlacedError for a value of another type.
class Object {
 public:
  Object(std::string tagName, std::string typeName, Place where)
      : tag(std::move(tagName)), type(std::move(typeName)), place(where) {}

  const Property* find(std::string_view name) const;
  bool has(std::string_view name) const { return find(name) != nullptr; }
  double number(std::string_view name, double absent) const;
  std::int64_t integer(std::string_view name, std::int64_t absent) const;
  bool flag(std::string_view name, bool absent) const;
  std::string text(std::string_view name, const std::string& absent) const;
  glm::dvec3 vector(std::string_view name, const glm::dvec3& absent) const;
  /// The identity if there is no such property.
  glm::dmat4 transform(std::string_view name) const;
  /// Returns the nested and referenced objects with a tag, whatever the names of their properties.
  std::vector<const Object*> nested(std::string_view tagName) const;
  /// Returns the only object that nested() returns, or null. Throws PlacedError if there are several.
  const Object* onlyNested(std::string_view tagName) const;

  /// Marks properties as used that have no effect on a picture, and notes them in the report.
  void ignore(std::initializer_list<std::string_view> names, Report& report) const;
  /// Marks properties as used that are not rendered, and notes them in the report.
  void omit(std::initializer_list<std::string_view> names, Report& report) const;
  /// Marks all properties as used.
  void useAll() const;
  /// Adds an error for each property that nothing has used.
  void reportUnused(Report& report) const;

  /// Returns "bsdf" and the type as messages show them: `bsdf "diffuse"`.
  std::string description() const;

  std::string tag;
  std::string type;
  std::string id{};
  Place place;
  std::vector<Property> properties{};

 private:
  template <class T>
  const T* valueOf(std::string_view name, const char* expected) const;

  mutable std::set<const Property*> used_{};
  mutable std::set<std::string, std::less<>> asked_{};  ///< names of properties that the reader knows
};

}  // namespace candela::mitsuba
