// Predicts the memory of a render, and refuses renders that do not fit.
#pragma once
#include <algorithm>
#include <cstdint>

#include "host/scene/scene.h"
#include "host/trace/render/settings.h"

namespace candela::job {

/// Host memory in bytes at the peak of a render.
struct MemoryNeed {
  std::uint64_t scene = 0;      ///< as it was read
  std::uint64_t structure = 0;  ///< building the acceleration structure, and a device's records
  std::uint64_t film = 0;       ///< the session and the result have one each
  std::uint64_t pictures = 0;   ///< the image of the outputs and its encoding, after the session has gone
  std::uint64_t pixels() const { return std::max(2 * film, film + pictures); }
  std::uint64_t total() const { return scene + structure + pixels(); }
};

MemoryNeed memoryNeedOf(const scene::Scene& scene, const render::ImageSettings& image,
                        const render::StructureSettings& structure, bool makesPictures);

/// Throws OutOfMemoryError, with the sizes and a remedy, if that exceeds the memory budget.
void requireMemoryForRender(const scene::Scene& scene, const render::ImageSettings& image,
                            const render::StructureSettings& structure, bool makesPictures);

}  // namespace candela::job
