// The shapes of primitives as one type, so that code for each kind is a set of overloads.
#pragma once
#include <variant>

#include "host/base/errors.h"
#include "host/scene/scene.h"

namespace candela::scene {

/// The shape of a primitive. A visitor without an overload for one of the kinds does not compile.
using Shape = std::variant<Sphere, Triangle, Box, Cone, Plane>;

inline Shape shapeOf(const Scene& scene, const Primitive& primitive) {
  switch (primitive.kind) {
    case PrimitiveKind::sphere:
      return scene.spheres[primitive.index];
    case PrimitiveKind::triangle:
      return triangleOf(scene, primitive);
    case PrimitiveKind::box:
      return scene.boxes[primitive.index];
    case PrimitiveKind::cone:
      return scene.cones[primitive.index];
    case PrimitiveKind::plane:
      return scene.planes[primitive.index];
  }
  throw InternalError("a primitive of an unknown kind");
}

}  // namespace candela::scene
