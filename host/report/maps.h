// The pictures of a report: both sides, and the maps of their differences.
#pragma once
#include <string>
#include <vector>

#include "host/report/report.h"

namespace candela::report {

/// One picture with what it shows, as HTML-free text.
struct Map {
  std::string id;
  std::string title;
  std::string caption;
  image::Pixels8 pixels;
};

/// The picture of one side, each pixel standing for k x k.
image::Pixels8 sidePicture(const image::Image& image, const image::DisplayTransform& display, std::uint32_t k);
/// The difference map, the FLIP map, and a t-map for every size of tiles that was tested.
std::vector<Map> mapsOf(const Report& report, std::uint32_t k);

}  // namespace candela::report
