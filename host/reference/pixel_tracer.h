// What the renderer asks of an integrator: the samples of pixels.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>

#include "host/reference/tracing.h"
#include "host/render/path_record.h"

namespace candela::reference {

/// A scene made ready to be rendered by one integrator. Threads share it.
class PixelTracer {
 public:
  virtual ~PixelTracer() = default;

  /// The radiance that one sample of a pixel sees. `record`, unless null, takes what its path or tree decided.
  virtual glm::dvec3 sample(std::uint32_t x, std::uint32_t y, std::uint32_t sampleIndex, Counters& counters,
                            PathRecord* record) const = 0;
  virtual const Tracing& tracing() const = 0;
};

}  // namespace candela::reference
