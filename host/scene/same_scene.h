// Compares scenes.
#pragma once
#include "host/scene/scene.h"

namespace candela::scene {

/// Returns whether two scenes differ at most in their cameras, their names and their hashes, so that all else that is
/// computed from one of them holds for the other.
bool differOnlyInCamera(const Scene& a, const Scene& b);

}  // namespace candela::scene
