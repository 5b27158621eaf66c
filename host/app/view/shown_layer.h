// Layers as a viewer shows them: the values of their pixels, and the colours that stand for the values. docs/viewer.md.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "host/app/view/picture.h"
#include "host/image/film.h"
#include "host/image/image.h"

namespace candela::view {

/// The content of a viewer: a layer, or the picture.
using ShownLayer = std::optional<image::Layer>;

/// Maximum depth of a pixel with hits. The layer `depth` has 1e10 where nothing was hit.
inline constexpr float kMaxDepthOfHits = 9.99e9f;

/// The layers that can be shown: all but `moments`.
std::span<const image::Layer> shownLayers();
/// Returns the name of the layer as --aov has it; `picture` for none.
std::string_view shownName(ShownLayer layer);
/// Returns the next one in the order of shownLayers(), with the picture before the first layer, or the one before.
ShownLayer nextLayer(ShownLayer layer, bool isBackwards);
/// Returns whether exposure and tone map apply to it: the picture, and the layers that are parts of its light.
bool isLight(ShownLayer layer);
/// Returns the layers of a film from which the layer is shown.
image::LayerSet neededBy(ShownLayer layer);

/// Replaces the values of each pixel as view::show() does, by those of a layer, which the film must have. Channels that
/// the layer lacks are 0. `variance` has the relative standard error of the mean and the variance. Mattes have the
/// colours of their ids, weighted by coverage, and their ids: Picture::ids.
void showLayer(const image::Film& film, image::Layer layer, Picture& picture);

/// Returns a colour that differs for different ids, as sRGB signals in [0, 1]; black for image::kNoId.
glm::vec3 idColour(std::uint32_t id);

/// The values of a picture to which its colours are fitted.
struct LayerRange {
  glm::vec3 minimum{0}, maximum{1};  ///< of each channel
  float median = 1;                  ///< of the first channel, > 0
};
/// Returns the range of the pixels that hit something, of `depth` and `position`.
LayerRange rangeOf(const Picture& picture);

/// The conversion of values to colours: v = (value - offset) * gain, or its fractional part, then the tone map.
struct LayerColours {
  image::ToneMap toneMap = image::ToneMap::srgb;
  glm::vec3 offset{0}, gain{1};
  float scale = 1;         ///< image::DisplayTransform::scale
  bool repeats = false;    ///< the fractional part is shown
  bool hidesZero = false;  ///< the value 0 is black: nothing was hit
};
/// Returns the colours of a layer, or of the picture. `display` applies where isLight(), and its exposure to
/// `variance`; `sampleCount` is the number of samples of a finished picture.
LayerColours coloursOf(ShownLayer layer, const image::DisplayTransform& display, const LayerRange& range,
                       std::uint32_t sampleCount);
/// Returns the colour of a value, as image::toDisplay() does. shaders/window.comp does the same within 1/255.
glm::u8vec3 toDisplay(const glm::vec3& value, const LayerColours& colours);
/// Returns the value that image::toDisplay() converts to this colour with colours.toneMap, colours.scale and no
/// exposure.
glm::vec3 exposed(const glm::vec3& value, const LayerColours& colours);

/// Returns which values the colours of a layer stand for, for the user. The layer is not isLight().
std::string keyText(ShownLayer layer, const image::DisplayTransform& display, const LayerRange& range,
                    std::uint32_t sampleCount);
/// Returns the values of a pixel as text: three of the picture, and those that the layer has.
std::string valueText(ShownLayer layer, const glm::vec3& value);
/// Returns the names of the two ids with the maximum coverage, and their coverage.
std::string matteText(const image::IdCounts& counts, const std::map<std::uint32_t, std::string>& names);

}  // namespace candela::view
