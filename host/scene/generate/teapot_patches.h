// The control points of Newell's teapot.
#pragma once
#include <array>
#include <glm/glm.hpp>

namespace candela::generate {

/// A bicubic Bezier patch with 16 control points.
using BezierPatch = std::array<std::array<glm::dvec3, 4>, 4>;

/// Returns M. Newell's data of 1975 as published with a bottom (F. Crow, IEEE CG&A 7(1), 1987), z up: rim, body,
/// handle, spout, lid, bottom.
std::array<BezierPatch, 32> teapotPatches();

}  // namespace candela::generate
