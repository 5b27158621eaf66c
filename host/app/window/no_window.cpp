// Replaces the window if its libraries were not found at build time.
#include "host/app/window/viewer.h"
#include "host/base/errors.h"

namespace candela::window {

ViewerReport runViewer(const ViewerOptions&) {
  throw NoDeviceError(
      "this candela was built without its viewer; install what it needs (Debian: apt-get install libglfw3-dev "
      "libimgui-dev) and build it again");
}

}  // namespace candela::window
