// Objects whose surfaces coincide, by name, for reports.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "host/scene/scene.h"

namespace candela::scene {

/// Two objects, or twice the same one, of which surfaces coincide: coincidence.h.
struct CoincidentObjects {
  std::string first;  ///< name of the object with the lower index
  std::string second;
  std::uint64_t copies = 0;    ///< number of primitives of `second` that have the shape of one of `first`
  std::uint64_t overlaps = 0;  ///< number of primitives of `second` that overlap one of `first` in one plane
};

/// Returns the pairs of objects, those with most primitives first.
std::vector<CoincidentObjects> coincidentObjects(const Scene& scene);

/// Returns a sentence without a full stop.
std::string toText(const CoincidentObjects& objects);

}  // namespace candela::scene
