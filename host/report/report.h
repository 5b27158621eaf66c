// A comparison as one page that needs nothing else: no network, no other file, and to be read no script either.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "host/image/flip.h"
#include "host/image/image.h"
#include "host/image/metrics.h"
#include "host/verify/region_result.h"

namespace candela::report {

enum class Outcome { agree, differ, none };

/// Texts may be anything, such as names of files that nobody chose with HTML in mind.
struct Figure {
  std::string name;
  std::string value;
};
/// What is known of both sides.
struct Fact {
  std::string name;
  std::string a;
  std::string b;
};

/// The tests of regions, the whole image first.
struct LightTests {
  std::vector<verify::RegionResult> regions;
  double level = 0;  ///< of each
};

struct Report {
  std::string title;
  Outcome outcome = Outcome::none;
  std::string verdict;  ///< one or more sentences
  std::string nameA, nameB;
  image::Image a, b;  ///< of equal size, linear
  image::DisplayTransform display;
  image::ImageComparison comparison;
  image::FlipResult flip;
  std::optional<LightTests> tests;
  std::vector<Figure> figures;  ///< before those of `comparison`
  std::vector<Fact> facts;
  std::vector<std::string> commands;  ///< for a shell
};

/// Equal reports give equal pages. Pictures of more than kMostPixels are reduced, and the page says so.
std::string toHtml(const Report& report);

}  // namespace candela::report
