// Looks up properties.
#include "host/formats/mitsuba/object.h"

#include <fmt/format.h>

#include <algorithm>

#include "host/base/quote.h"
#include "host/base/setting_words.h"
#include "host/formats/mitsuba/names.h"

namespace candela::mitsuba {

using scene::quote;

const Property* Object::find(std::string_view name) const {
  if (!asked_.contains(name)) asked_.emplace(name);
  const auto found = std::ranges::find(properties, name, &Property::name);
  if (found == properties.end()) return nullptr;
  used_.insert(&*found);
  return &*found;
}

template <class T>
const T* Object::valueOf(std::string_view name, const char* expected) const {
  const Property* const property = find(name);
  if (!property) return nullptr;
  const T* const value = std::get_if<T>(&property->value);
  if (!value)
    throw PlacedError{property->place, fmt::format("{} of {} is not {}", quote(name), description(), expected)};
  return value;
}

double Object::number(std::string_view name, double absent) const {
  const Property* const property = find(name);
  if (property) {
    if (const auto* const integer = std::get_if<std::int64_t>(&property->value)) return static_cast<double>(*integer);
  }
  const double* const value = valueOf<double>(name, "a number");
  return value ? *value : absent;
}

std::int64_t Object::integer(std::string_view name, std::int64_t absent) const {
  const std::int64_t* const value = valueOf<std::int64_t>(name, "an integer");
  return value ? *value : absent;
}

bool Object::flag(std::string_view name, bool absent) const {
  const bool* const value = valueOf<bool>(name, "a boolean");
  return value ? *value : absent;
}

std::string Object::text(std::string_view name, const std::string& absent) const {
  const std::string* const value = valueOf<std::string>(name, "a string");
  return value ? *value : absent;
}

glm::dvec3 Object::vector(std::string_view name, const glm::dvec3& absent) const {
  const glm::dvec3* const value = valueOf<glm::dvec3>(name, "a point or vector");
  return value ? *value : absent;
}

glm::dmat4 Object::transform(std::string_view name) const {
  const glm::dmat4* const value = valueOf<glm::dmat4>(name, "a transform");
  return value ? *value : glm::dmat4(1);
}

std::vector<const Object*> Object::nested(std::string_view tagName) const {
  std::vector<const Object*> objects;
  for (const Property& property : properties) {
    const auto* const object = std::get_if<const Object*>(&property.value);
    if (!object || (*object)->tag != tagName) continue;
    used_.insert(&property);
    objects.push_back(*object);
  }
  return objects;
}

const Object* Object::onlyNested(std::string_view tagName) const {
  const std::vector<const Object*> objects = nested(tagName);
  if (objects.size() > 1) {
    throw PlacedError{objects[1]->place, fmt::format("{} has a second {}", description(), tagName)};
  }
  return objects.empty() ? nullptr : objects.front();
}

void Object::ignore(std::initializer_list<std::string_view> names, Report& report) const {
  for (const std::string_view name : names) {
    if (find(name)) report.ignore(fmt::format("{} of {}", name, description()));
  }
}

void Object::omit(std::initializer_list<std::string_view> names, Report& report) const {
  for (const std::string_view name : names) {
    if (find(name)) report.omit(fmt::format("{} of {}", name, description()));
  }
}

void Object::useAll() const {
  for (const Property& property : properties) used_.insert(&property);
}

void Object::reportUnused(Report& report) const {
  for (const Property& property : properties) {
    if (used_.contains(&property)) continue;
    if (property.name.empty()) {
      const auto* const object = std::get_if<const Object*>(&property.value);
      report.deviate(property.place,
                     fmt::format("{} has no use for {}", description(), object ? (*object)->description() : "this"),
                     "leaves it out");
      continue;
    }
    const std::vector<std::string_view> names(asked_.begin(), asked_.end());
    report.deviate(property.place,
                   fmt::format("{} has no property {}{}", description(), quote(property.name),
                               suggestionFor(property.name, names)),
                   "leaves it out");
  }
}

std::string Object::description() const {
  return type.empty() || tag == "scene" ? tag : fmt::format("{} {}", tag, quote(type));
}

}  // namespace candela::mitsuba
