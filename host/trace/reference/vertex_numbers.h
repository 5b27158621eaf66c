// The random numbers of one vertex of a path.
#pragma once
#include <cstdint>

#include "host/trace/reference/sampler.h"
#include "shaders/shared/dimensions.h"

namespace candela::reference {

/// The functions are named as the dimensions in shaders/shared/dimensions.h. `depth`, the vertex, counts from 1.
struct VertexNumbers {
  SampleNumbers& numbers;
  std::uint32_t depth;
  std::uint32_t block;
  std::uint32_t environmentBlock;

  VertexNumbers(SampleNumbers& pathNumbers, std::uint32_t vertex)
      : numbers(pathNumbers),
        depth(vertex),
        block(kCameraDimensionCount + (vertex - 1) * kVertexDimensionCount),
        environmentBlock(kEnvironmentDimensions + (vertex - 1) * kEnvironmentDimensionCount) {}

  std::uint32_t lightChoice() const { return numbers.word(block + kDimensionLightChoice); }
  dvec2 light() const { return {numbers.unit(block + kDimensionLightU), numbers.unit(block + kDimensionLightV)}; }
  glm::uvec2 lightWords() const {
    return {numbers.word(block + kDimensionLightU), numbers.word(block + kDimensionLightV)};
  }
  dvec2 tap() const { return environmentPair(kDimensionTapX, kDimensionTapY); }
  dvec2 texel() const { return environmentPair(kDimensionTexelX, kDimensionTexelY); }
  dvec2 environmentPair(std::uint32_t x, std::uint32_t y) const {
    return {numbers.unit(environmentBlock + x), numbers.unit(environmentBlock + y)};
  }
  /// The number that decides at a node of this depth of a light tree, whose numbers start at a dimension.
  std::uint32_t lightTree(std::uint32_t dimensions, std::uint32_t treeDepth) const {
    return numbers.word(dimensions + (depth - 1) * kLightTreeDimensionCount + treeDepth);
  }
  double lobe() const { return numbers.unit(block + kDimensionLobe); }
  dvec2 bsdf() const { return {numbers.unit(block + kDimensionBsdfU), numbers.unit(block + kDimensionBsdfV)}; }
  double facet() const { return numbers.unit(block + kDimensionFacet); }
  double layer() const { return numbers.unit(block + kDimensionLayer); }
  double coatFacet() const { return numbers.unit(block + kDimensionCoatFacet); }
  double channel() const { return numbers.unit(block + kDimensionChannel); }
  double material() const { return numbers.unit(block + kDimensionMaterial); }
  double roulette() const { return numbers.unit(block + kDimensionRoulette); }
};

}  // namespace candela::reference
