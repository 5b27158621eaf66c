// Requires that a device did all of its work.
#include "host/render/statistics.h"

#include <fmt/format.h>

#include "host/core/errors.h"

namespace candela::render {

void requireComplete(const RenderStatistics& statistics) {
  if (statistics.truncated == 0) return;
  if (statistics.structure == AccelKind::grid) {
    throw FileError(
        fmt::format("the device stopped {} traversals of the grid early, so the image would be wrong and is not "
                    "written; use --accel bvh",
                    statistics.truncated));
  }
  throw InternalError(fmt::format(
      "the device stopped {} loops early, so the image would be wrong and is not written; a smaller "
      "--segments-per-dispatch, another --accel or another device may help, and --device cpu has no such limit",
      statistics.truncated));
}

}  // namespace candela::render
