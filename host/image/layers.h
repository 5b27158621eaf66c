// Layers: quantities of the surfaces that camera rays hit, and parts of the light, as exact sums beside the film.
// docs/layers.md defines them.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host/image/mattes.h"
#include "lists/layer_sums.h"

namespace candela::image {

enum class Layer : std::uint32_t {
  normal,
  albedo,
  depth,
  position,
  uv,
  direct,
  indirect,
  emission,
  variance,
  samples,
  moments,       ///< what `candela denoise` needs; has the sums of normal and albedo, too
  cryptoObject,  ///< counts of ids and no sums, like the next
  cryptoMaterial
};

/// A set of layers.
struct LayerSet {
  std::uint32_t bits = 0;

  bool has(Layer layer) const { return (bits >> static_cast<std::uint32_t>(layer) & 1u) != 0; }
  void add(Layer layer) { bits |= 1u << static_cast<std::uint32_t>(layer); }
  bool isEmpty() const { return bits == 0; }
  bool operator==(const LayerSet&) const = default;
};

/// Names of all layers, indexed by Layer.
std::span<const std::string_view> layerNames();

/// Returns the names of a layer's channels in files, such as `N.X`, in their order; none for `variance` and `samples`.
std::span<const std::string> layerChannelNames(Layer layer);

/// Returns `layers` without those that every film has, `variance` and `samples`.
LayerSet withSums(LayerSet layers);

/// Returns whether the layers include the mattes of a kind, or of any kind.
bool hasMatte(LayerSet layers, MatteKind kind);
bool hasMattes(LayerSet layers);
/// Returns the kind of a matte; nothing for other layers.
std::optional<MatteKind> matteKindOf(Layer layer);

/// Returns the names of the layers, separated by commas; `none` for an empty set.
std::string layerText(LayerSet layers);

/// The sums that a pixel has; the enumerators are the bits of a mask.
enum class LayerSum : std::uint32_t {
#define CANDELA_DECLARE_SUM(sum, has, row, bit, count) sum = 1u << bit,
  CANDELA_LAYER_SUMS(CANDELA_DECLARE_SUM)
#undef CANDELA_DECLARE_SUM
};

/// Returns the mask of the sums from which the layers are computed. `variance` and `samples` need none, because the
/// film has them, and mattes are counts.
std::uint32_t layerSumsOf(LayerSet layers);
/// Returns the number of records of a pixel with these sums, the header included; 0 for no sums.
std::uint32_t layerRowCount(std::uint32_t sums);
/// Returns the index of the sum's first record in a pixel's records. The mask must contain the sum.
std::uint32_t firstLayerRow(std::uint32_t sums, LayerSum sum);

/// Returns the names of a pixel's records with these sums, such as `normal.X`, in their order, without the header.
std::vector<std::string> layerSumNames(std::uint32_t sums);

/// A 16-byte record of a pixel; the device has the same layout. In the first record, the header, `words` are the number
/// of samples whose camera ray hit something and the number of samples with a value that is not finite or above
/// kFilmMaximum in magnitude. Every other record belongs to a channel: its sum in units of 2^-40, 96 bits in two's
/// complement, least significant word first. `pending` is used on the device only, and 0 elsewhere.
struct LayerRow {
  std::array<std::uint32_t, 3> words{};
  std::uint32_t pending = 0;

  bool operator==(const LayerRow&) const = default;
};
static_assert(sizeof(LayerRow) == 16);

/// Adds the records of other samples of the same pixel.
void addLayerRows(std::span<LayerRow> sums, std::span<const LayerRow> terms);

/// The values that one sample adds.
struct LayerSample {
  struct FirstHit {
    glm::dvec3 normal{0};
    glm::dvec3 albedo{0};
    double depth = 0;
    glm::dvec3 position{0};
    glm::dvec2 texCoord{0};
    std::uint32_t primitive = 0;
  };
  std::optional<FirstHit> hit;              ///< empty: the camera ray hit nothing
  std::optional<glm::dvec3> unscattered;    ///< the path's radiance before the first scattering's light was added
  std::optional<glm::dvec3> scatteredOnce;  ///< the path's radiance before the second scattering's light was added
};

/// Adds a sample to a pixel's records. `radiance` is the value of the sample, which also stands for a part of the light
/// that is empty because the path ended before.
void addLayerSample(std::span<LayerRow> rows, std::uint32_t sums, const LayerSample& sample,
                    const glm::dvec3& radiance);

}  // namespace candela::image
