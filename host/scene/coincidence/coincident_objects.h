// Objects whose surfaces coincide, by name, for reports.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/scene/scene.h"

namespace candela::scene {

/// Two objects, or twice the same one, of which surfaces coincide: coincidence.h.
struct CoincidentObjects {
  /// Primitives of both objects, each counted once.
  struct Count {
    std::uint64_t first = 0;
    std::uint64_t second = 0;
  };

  std::string first;  ///< name of the object with the lower index
  std::string second;
  bool isOne = false;  ///< whether both are the same object: different objects may have the same name
  Count copies;        ///< primitives of `second` that have the shape of primitives of `first`, which are not copies
  Count overlaps;      ///< primitives of `second` that overlap primitives of `first` in one plane
  std::string firstNoun, secondNoun;  ///< of one such primitive: its kind, or "primitive" if there are several kinds
};

struct CoincidenceReport {
  std::vector<CoincidentObjects> pairs;  ///< those with most primitives first
  /// Number of primitives that coincide with others or overlap them in one plane. Nothing if there are too many
  /// comparisons: then `pairs` has copies alone.
  std::optional<std::uint64_t> primitiveCount = 0;
};

CoincidenceReport coincidentObjects(const Scene& scene);

/// Returns a sentence without a full stop.
std::string toText(const CoincidentObjects& objects);
/// Returns such sentences: the total if there are several pairs, and the first pairs.
std::vector<std::string> linesOf(const CoincidenceReport& report);

}  // namespace candela::scene
