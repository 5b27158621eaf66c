// The difference between two images in alpha and in the channels of layers.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "host/image/image.h"

namespace candela::image {

/// The difference of one channel. Values that are equal bit by bit are equal, also where they are not finite.
struct ChannelDifference {
  std::string name;
  bool isId = false;
  /// Mean of (a - b)^2 / (max(a^2, b^2) + 0.01), which is at most 4, over the pixels with finite values. It equals
  /// relMSE where a and b are similar, and a value that one side lacks, such as a depth of 1e10, counts as one wrong
  /// pixel. 0 for ids.
  double relativeMeanSquaredError = 0;
  std::uint64_t differingCount = 0;         ///< pixels whose values are not equal
  std::uint64_t notFiniteCount = 0;         ///< of these, pixels with a value that is not finite; 0 for ids
  double maximumDifference = 0;             ///< maximum of |a - b| over finite values; 0 for ids
  std::int64_t maximumX = 0, maximumY = 0;  ///< first pixel with it, or whose ids differ, in the plane of the picture

  bool isEqual() const { return differingCount == 0; }
  /// Returns whether the error is at most `tolerance`. Ids must be equal.
  bool isWithin(double tolerance) const;
};

struct ChannelComparison {
  bool comparesColours = true;  ///< whether R, G and B are compared as the picture
  std::vector<ChannelDifference> channels;
  std::vector<std::string> onlyInA, onlyInB;  ///< channels that the other image lacks, which are not compared
};

/// Compares two images of equal size: alpha (1 where an image has none), unless both lack it, and all channels that
/// both have. `selected` names those that are compared instead; a name is that of a channel, of all channels before a
/// full stop (`N` for `N.X`), or of a layer (`normal`). R, G and B together are the picture; fewer of them are compared
/// as channels. Throws UsageError if an image lacks a channel that is selected.
ChannelComparison compareChannels(const Image& a, const Image& reference,
                                  const std::vector<std::string>& selected = {});

/// Returns a line for each channel that is compared, and for those that only one image has, each ending in a newline.
std::string toText(const ChannelComparison& comparison);
/// Adds `channels`, `onlyInA` and `onlyInB`.
void addToJson(const ChannelComparison& comparison, nlohmann::ordered_json& json);

}  // namespace candela::image
