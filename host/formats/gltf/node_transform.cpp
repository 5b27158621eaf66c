// Reads the matrix of a node, or composes its translation, rotation and scale.
#include "host/formats/gltf/node_transform.h"

#include <glm/gtc/matrix_access.hpp>

namespace candela::gltf {
namespace {

glm::dmat4 matrixOf(const Value& matrix) {
  if (matrix.size() != 16) matrix.fail("expected an array of 16 numbers");
  glm::dmat4 result;
  for (std::size_t i = 0; i < 16; ++i) {
    result[static_cast<glm::length_t>(i / 4)][static_cast<glm::length_t>(i % 4)] = matrix[i].number();
  }
  constexpr double kRounding = 1e-5;  // of programs that multiply matrices in single precision
  const glm::dvec4 affine(0, 0, 0, 1);
  if (glm::any(glm::greaterThan(glm::abs(glm::row(result, 3) - affine), glm::dvec4(kRounding)))) {
    matrix.fail("the last row is not 0 0 0 1");
  }
  return glm::row(result, 3, affine);
}

glm::dquat rotationOf(const Value& node) {
  const glm::dvec4 xyzw = node.vectorOr("rotation", glm::dvec4(0, 0, 0, 1));
  return {xyzw.w, xyzw.x, xyzw.y, xyzw.z};
}

}  // namespace

glm::dmat4 compose(const glm::dvec3& translation, const glm::dquat& rotation, const glm::dvec3& scale) {
  const double length = glm::length(rotation);
  const glm::dmat3 rotated = length > 0 ? glm::mat3_cast(rotation / length) : glm::dmat3(1);
  return {glm::dvec4(scale.x * rotated[0], 0), glm::dvec4(scale.y * rotated[1], 0), glm::dvec4(scale.z * rotated[2], 0),
          glm::dvec4(translation, 1)};
}

glm::dmat4 localTransform(const Value& node, const NodePose& pose) {
  const std::optional<Value> matrix = node.find("matrix");
  const bool isPosed = pose.translation || pose.rotation || pose.scale;
  if (matrix && isPosed) matrix->fail("an animated node has a matrix instead of translation, rotation and scale");
  if (matrix) return matrixOf(*matrix);
  return compose(pose.translation.value_or(node.vectorOr("translation", glm::dvec3(0))),
                 pose.rotation.value_or(rotationOf(node)), pose.scale.value_or(node.vectorOr("scale", glm::dvec3(1))));
}

}  // namespace candela::gltf
