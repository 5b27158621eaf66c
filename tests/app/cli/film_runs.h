// Renders that write films, divided, stopped and killed.
#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/app/cli/run_program.h"

namespace candela {

/// Runs of candela with common options.
struct FilmRuns {
  std::vector<std::string> common;

  /// Options that are given again replace the common ones.
  ProgramResult run(const std::string& scene, const std::vector<std::string>& options,
                    const Surroundings& surroundings = {}) const;
  /// Renders with --checkpoint FILE and returns the bytes of the file; requires success.
  std::string film(const std::string& scene, const std::string& file,
                   const std::vector<std::string>& options = {}) const;
  /// Returns the stderr of a run that must end with exit code 2.
  std::string refusal(const std::string& scene, const std::vector<std::string>& options) const;
};

inline const FilmRuns kReference{{"--device", "cpu", "--size", "48x36", "--spp", "12"}};

inline nlohmann::json jsonOf(const std::string& file) { return nlohmann::json::parse(readText(file)); }

/// Requires that the film of a render of 48x36 pixels and 12 or more samples has the same bytes in one run, from shards
/// by samples, by crops and by both, merged in two orders, and resumed twice.
void requireEqualDivisions(const FilmRuns& runs, const TemporaryFolder& folder,
                           const std::vector<std::string>& options);

/// Kills renders, which write their films all the time because of SIGUSR1, at `even` evenly spaced and at `random`
/// random moments of their duration. Requires that each leaves no film or a good one, no other file, and that the
/// resumed render has the bytes of a run that is not killed.
void requireSurvivesKills(const FilmRuns& runs, int even, int random);

}  // namespace candela
