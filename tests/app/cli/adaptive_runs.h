// Adaptively sampled films that are interrupted and divided.
#pragma once
#include <csignal>
#include <string>
#include <vector>

#include "tests/app/cli/film_runs.h"

namespace candela {

/// A floor with a caustic in the upper left of the image: some regions are noisy, others are not.
inline std::string causticScene() {
  return "bclr .3 .3 .3\nv\nfrom 0 -6 3\nat .4 .2 -.2\nup 0 0 1\nangle 50\nhither 0\nresolution 64 64\n"
         "f .6 .6 .6 1 0 0 0 0 1 0 1 0 0 0\npl 0 0 0 1 0 0 0 1 0\n"
         "f 1 1 1 0 0 0 0 0 1 1 1.5 0 0 0\ns -1.4 .9 .7 .7\n"
         "f 0 0 0 1 0 0 0 0 1 0 1 15 14 12\ns 1 3 5 .6\n";
}

/// The options of renders that stop some regions of that scene at several levels.
inline std::vector<std::string> adaptiveOptions(std::vector<std::string> more) {
  more.insert(more.end(), {"--spp", "96", "--noise-threshold", "0.2"});
  return more;
}

/// Requires that a film of 72x68 pixels has the same bytes in one run, merged from crops, resumed after `stops` stops
/// at various times, and with checkpoints.
void requireEqualAdaptiveFilms(const FilmRuns& runs, const TemporaryFolder& folder, int stops);

}  // namespace candela
