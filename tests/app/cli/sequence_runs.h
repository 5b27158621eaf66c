// Sequences that are rendered like single images, divided, stopped and resumed, on any tracer.
#pragma once
#include <string>
#include <vector>

#include "tests/app/cli/run_program.h"

namespace candela {

/// A triangle that moves from x = -1 to 1 in one second (glTF).
std::string movingTriangle();

/// Runs candela with common options of small renders.
struct SequenceRuns {
  std::vector<std::string> common;

  ProgramResult run(const std::string& scene, const std::vector<std::string>& options,
                    const Surroundings& surroundings = {}) const;
};

inline const SequenceRuns kReferenceFrames{{"--device", "cpu", "--size", "24x18", "--spp", "4"}};

/// Requires that frames of an animation, of a turntable and of both have the bytes of single renders, pictures and
/// films.
void requireFramesOfSingleRenders(const SequenceRuns& runs);

/// Requires that a sequence that lost films, pictures and parts of films is completed, with the bytes of one run, and
/// that nothing else is rendered again.
void requireResumption(const SequenceRuns& runs);

}  // namespace candela
