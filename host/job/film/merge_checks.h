// Refuses films that cannot be merged. All functions throw FileError.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "host/job/film/merge.h"

namespace candela::film {

/// A film that is not open.
struct MergePart {
  std::filesystem::path file;
  FilmHeader header;
  std::string check;
};

/// Returns the boxes of `covered` and `begun`.
std::vector<SampleBox> allBoxes(const FilmHeader& header);

/// Refuses films of different estimates, tracers that may not be mixed, and samples that several films have.
void requireFitting(const std::vector<MergePart>& parts, const MergeOptions& options);
/// Refuses a merged film that readers would refuse.
void requireReadable(const FilmHeader& merged);
/// Refuses interrupted films and missing samples.
void requireWhole(const std::vector<MergePart>& parts, const std::vector<SampleBox>& missing);

}  // namespace candela::film
