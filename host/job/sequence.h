// Sequences of frames: which frames, and the names of their files.
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>

namespace candela::job {

/// Frames first, first + 1, ..., end - 1.
struct FrameRange {
  std::uint32_t first = 0;
  std::uint32_t end = 0;

  std::uint32_t count() const { return end - first; }
  bool operator==(const FrameRange&) const = default;
};

/// Returns whether the name of a file has a place for the number of a frame: one or more #.
bool isFramePattern(const std::filesystem::path& file);

/// Returns the file of a frame: the last run of # in the name of the pattern is replaced by the number of the frame,
/// with zeros in front up to the length of the run. Other paths are returned as they are.
std::filesystem::path frameFile(const std::filesystem::path& pattern, std::uint32_t frame);

}  // namespace candela::job
