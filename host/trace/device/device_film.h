// The film of a session on a device: all of it on the host, and the rows of one band also on the device.
#pragma once
#include <cstdint>
#include <optional>
#include <span>

#include "host/image/film.h"
#include "host/scene/object_names.h"
#include "host/trace/device/band.h"
#include "host/trace/render/film_coverage.h"
#include "host/trace/render/pixel_mask.h"

namespace candela::device {

/// The film is divided into bands of equal height, but for the last one. The film of one of them may be *resident*: its
/// newest samples are in the buffers of a Band, until they are fetched.
class DeviceFilm {
 public:
  /// Makes a film without pixels, whose mattes have ids of the scene's objects. The scene must outlive the object.
  DeviceFilm(const scene::Scene& scene, const image::LayerSet& layers);

  /// Empties the film and makes it as large as the window of `image`, which has the layers of the film.
  void resize(const render::ImageSettings& image);
  /// Divides the film into bands of `height` rows, at least 1. No band may be resident.
  void setBandHeight(std::uint32_t height) { bandHeight_ = height; }

  render::Extent size() const { return {film_.width(), film_.height()}; }
  /// image::Film::radianceOfOne() of the film, which binary32 represents exactly.
  float radianceOfOne() const { return static_cast<float>(film_.radianceOfOne()); }
  std::uint32_t bandHeight() const { return bandHeight_; }
  std::uint32_t bandCount() const;
  BandRows rowsOf(std::uint32_t band) const;

  /// Removes all samples and the restriction to a mask.
  void clear();
  /// Replaces all samples by those of `film`, which has the size and the layers of this one.
  void load(const image::Film& film, const render::FilmCoverage& coverage);
  /// Restricts the following samples to the pixels of `mask`. No band may be resident.
  void restrictTo(const render::PixelMask& mask);
  /// Makes `sample` the first sample of each pixel. The film must be empty.
  void startAt(std::uint32_t sample);
  /// Notes that all pixels have the samples up to `sampleEnd`, exclusive, unless the film is restricted to some.
  void noteFinished(std::uint32_t sampleEnd);
  /// Notes that pixels may have different numbers of samples.
  void noteUneven() { coverage_.samples = render::FilmCoverage::kUneven; }

  const render::FilmCoverage& coverage() const { return coverage_; }
  /// Returns the minimum number of samples of a pixel of these rows, as last fetched.
  std::uint32_t minSamples(BandRows rows) const;
  /// Returns the minimum number of samples of a pixel. If pixels have different numbers, the film must be fetched.
  std::uint32_t minSamples() const;
  /// Returns the number of selected pixels of these rows that lack samples before `sampleEnd`. If pixels have different
  /// numbers of samples, the film must be fetched.
  std::uint64_t pixelsLacking(BandRows rows, std::uint32_t sampleEnd) const;

  std::optional<std::uint32_t> residentBand() const { return resident_; }
  /// Copies the film of a band to the device if it is not resident, and expects that samples are added there. No other
  /// band may be resident. `band` must outlive the residence.
  void makeResident(std::uint32_t index, Band& band);
  /// Fetches the film of the resident band, and counts its hits if the image has mattes. Adds the duration to
  /// `statistics`.
  void fetch(render::RenderStatistics& statistics);
  /// Fetches the film of the resident band if samples may have been added since the last time.
  void update(render::RenderStatistics& statistics);
  /// Ends the residence. Samples that were not fetched are lost.
  void release() { resident_.reset(); }

  /// Returns the film in device memory, or null if the device does not have all of it: no sample was traced since the
  /// film was emptied or loaded, or it has several bands.
  const vulkan::Buffer* buffer() const;
  /// Returns the film as last fetched.
  const image::Film& fetched() const { return film_; }
  /// Moves the film as last fetched out of the object, which can only be destroyed afterwards.
  image::Film take() { return std::move(film_); }
  /// Returns the numbers of samples, as last fetched, without those that were loaded.
  image::FilmCounts added() const;

 private:
  void startAgain();
  std::span<image::FilmPixel> pixelsOf(BandRows rows);
  std::span<const image::FilmPixel> pixelsOf(BandRows rows) const;
  std::span<image::LayerRow> layersOf(BandRows rows);

  std::optional<scene::MatteIds> matteIds_;  ///< of an image with mattes
  image::Film film_;
  std::uint32_t bandHeight_ = 1;
  render::FilmCoverage coverage_;  ///< including samples that were not fetched
  render::PixelMask mask_;         ///< pixels that get samples
  image::FilmCounts loaded_;       ///< of the film that was loaded
  std::optional<std::uint32_t> resident_;
  Band* band_ = nullptr;    ///< the buffers of the resident band
  bool isFetched_ = false;  ///< film_ has all samples of the resident band
};

}  // namespace candela::device
