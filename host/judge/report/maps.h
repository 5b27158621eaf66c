// The pictures of a report: both images, and maps of their differences.
#pragma once
#include <string>
#include <vector>

#include "host/judge/report/report.h"

namespace candela::report {

/// One picture with its caption, as plain text.
struct Map {
  std::string id;
  std::string title;
  std::string caption;
  image::Pixels8 pixels;
};

/// Returns the picture of one side, in which each pixel represents k x k pixels.
image::Pixels8 sidePicture(const image::Image& image, const image::DisplayTransform& display, std::uint32_t k);
/// Returns the difference map, the FLIP map, and a map of t for every size of tiles that was tested.
std::vector<Map> mapsOf(const Report& report, std::uint32_t k);

}  // namespace candela::report
