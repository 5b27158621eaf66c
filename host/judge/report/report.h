// A comparison as one self-contained page, which needs no network and no other file, and can be read without scripts.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "host/image/flip.h"
#include "host/image/image.h"
#include "host/image/metrics.h"
#include "host/judge/verify/conclusion.h"
#include "host/judge/verify/region_result.h"

namespace candela::report {

enum class Outcome { agree, differ, undecided, none };
/// Returns the outcome of a verdict.
Outcome outcomeOf(verify::Conclusion conclusion);

/// Texts may be arbitrary, such as file names with HTML characters.
struct Figure {
  std::string name;
  std::string value;
};
/// A property of both sides.
struct Fact {
  std::string name;
  std::string a;
  std::string b;
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
  std::optional<verify::RegionTests> tests;
  std::vector<Figure> figures;  ///< shown before those of `comparison`
  std::vector<Fact> facts;
  std::vector<std::string> commands;  ///< shell commands
};

/// Returns the page. Equal reports give equal pages. Pictures of more than kMaxPixels are reduced, with a note.
std::string toHtml(const Report& report);

}  // namespace candela::report
