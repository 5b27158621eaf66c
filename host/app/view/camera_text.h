// A camera as text that scene files and the command line read.
#pragma once
#include <string>

#include "host/scene/scene.h"

namespace candela::view {

/// Returns the view of an NFF or P3F file, one entry per line, with as many digits as binary32 needs. An orthographic
/// camera, which these files cannot have, is preceded by a comment.
std::string cameraText(const scene::Camera& camera);

}  // namespace candela::view
