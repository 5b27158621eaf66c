// Compares the frames and the windows of two pictures.
#include "host/image/alignment.h"

#include <fmt/format.h>

namespace candela::image {

std::string whyApart(const Image& a, const Image& b) {
  const PixelBox frameOfA = frameOf(a), frameOfB = frameOf(b);
  if (frameOfA != frameOfB && frameOfA.x == frameOfB.x && frameOfA.y == frameOfB.y) {
    return fmt::format("A has the size {}x{} and B the size {}x{}", frameOfA.width, frameOfA.height, frameOfB.width,
                       frameOfB.height);
  }
  if (frameOfA != frameOfB) {
    return fmt::format("A has the frame {} and B the frame {}", boxText(frameOfA), boxText(frameOfB));
  }
  const PixelBox inA = windowOf(a), inB = windowOf(b);
  if (inA.contains(inB) || inB.contains(inA)) return "";
  return fmt::format("A has the window {} of the frame and B the window {}, neither of which contains the other",
                     boxText(inA), boxText(inB));
}

void cutToCommonWindow(Image& a, Image& b) {
  if (windowOf(a) == windowOf(b)) return;
  Image& larger = windowOf(a).contains(windowOf(b)) ? a : b;
  const Image& smaller = &larger == &a ? b : a;
  larger = partOf(larger, windowOf(smaller));
}

}  // namespace candela::image
