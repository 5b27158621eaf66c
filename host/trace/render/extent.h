// Sizes and rectangles of images and of grids of invocations, by the names that the tracers use.
#pragma once
#include "host/scene/extent.h"

namespace candela::render {

using scene::Extent;
using scene::extentText;
using scene::isWithin;
using scene::Window;
using scene::windowOf;
using scene::windowText;

}  // namespace candela::render
