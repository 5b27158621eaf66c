// The flat surfaces of the primitives that belong to no instance.
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "host/scene/coincidence/flat_surface.h"
#include "host/scene/scene.h"
#include "host/scene/stored_primitives.h"

namespace candela::scene {

/// Their primitives are indices in Scene::primitives.
class FlatSurfaces {
 public:
  /// `firstCopy`: result of firstUnplacedCopies(). Copies are left out.
  FlatSurfaces(const Scene& scene, const StoredPrimitives& stored, std::span<const std::uint32_t> firstCopy,
               std::uint32_t threadCount);

  const FlatSurface& operator[](std::uint32_t index) const { return surfaces_[index]; }
  /// Returns the boxes of the finite surfaces. Their items are indices for operator[].
  std::vector<ItemBox> takeBoxes() { return std::move(boxes_); }
  std::span<const FlatSurface> infinite() const { return infinite_; }

 private:
  void store(const Shape& shape, std::uint32_t primitive, std::span<FlatSurface> parts, std::size_t first);

  std::unique_ptr<FlatSurface[]> surfaces_;
  std::vector<ItemBox> boxes_;
  std::vector<FlatSurface> infinite_;
};

}  // namespace candela::scene
