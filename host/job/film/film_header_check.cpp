// The conditions on the header of a film that concern several of its members.
#include <fmt/format.h>

#include <algorithm>

#include "host/base/errors.h"
#include "host/job/film/film_header_parts.h"

namespace candela::film {
namespace {

bool liesWithin(const render::Window& inner, const render::Window& outer) {
  return inner.x >= outer.x && inner.y >= outer.y && inner.x + inner.width <= outer.x + outer.width &&
         inner.y + inner.height <= outer.y + outer.height;
}

void checkBoxes(const std::vector<SampleBox>& boxes, const FilmHeader& header, const JsonValue& list) {
  const auto isInside = [&](const SampleBox& box) { return liesWithin(box.window, header.window); };
  if (!std::ranges::all_of(boxes, isInside)) list.fail("a box exceeds the window");
  if (!isCanonical(boxes)) list.fail("the boxes overlap, or are not in the form that is written");
}

void checkBothLists(const FilmHeader& header, const JsonValue& root) {
  const JsonValue begun = root.require("begun");
  checkBoxes(header.covered, header, root.require("covered"));
  checkBoxes(header.begun, header, begun);
  std::vector<SampleBox> all = header.covered;
  all.insert(all.end(), header.begun.begin(), header.begun.end());
  if (all.size() > kMaxBoxes) begun.fail(fmt::format("expected at most {} boxes in both lists", kMaxBoxes));
  try {
    requireDisjoint(all);
  } catch (const Error&) {
    begun.fail("the boxes overlap those of \"covered\"");
  }
}

}  // namespace

void checkHeader(const FilmHeader& header, const JsonValue& root) {
  const bool isHash = header.sceneHash.size() == 16 &&
                      header.sceneHash.find_first_not_of("0123456789abcdef") == std::string::npos;
  if (!isHash) root.require("scene").fail("expected 16 hexadecimal digits");
  checkBothLists(header, root);
  if (header.tracers.empty()) root.require("tracers").fail("expected at least one tracer");
  if (!isSortedSet(header.tracers)) root.require("tracers").fail(kExpectsSortedSet);
  if (!isSortedSet(header.mixed)) root.require("mixed").fail(kExpectsSortedSet);
  static_cast<void>(header.filmScale());
  const auto rule = header.settings.find(kStoppingRule);
  const bool hasRule = rule != header.settings.end();
  if (hasRule && (rule->second != kCurrentStoppingRule || !header.noiseThreshold())) {
    root.require("settings").require(kStoppingRule).fail("the rule is unknown, or there is no noise threshold");
  }
  if (header.noiseThreshold() && header.samplesPerPixel <= render::pilotSamples(*header.noiseThreshold())) {
    root.require("samplesPerPixel").fail("too few samples for the noise threshold");
  }
}

}  // namespace candela::film
