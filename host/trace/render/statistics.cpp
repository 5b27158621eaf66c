// Requires that a device did all of its work.
#include "host/trace/render/statistics.h"

#include <fmt/format.h>

#include "host/base/errors.h"
#include "host/base/setting_words.h"

namespace candela::render {

void requireComplete(const RenderStatistics& statistics) {
  if (statistics.truncated == 0) return;
  if (statistics.structure == AccelKind::grid) {
    throw FileError(
        fmt::format("the device stopped {} traversals of the grid early, so the image would be wrong and is not "
                    "written; use {}",
                    statistics.truncated, settingWords("accel", "bvh")));
  }
  throw InternalError(
      fmt::format("the device stopped {} loops early, so the image would be wrong and is not written; a smaller "
                  "{}, another {} or another device may help, and the reference tracer has no such limit",
                  statistics.truncated, settingWords("segments-per-dispatch"), settingWords("accel")));
}

}  // namespace candela::render
