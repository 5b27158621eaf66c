// Compares the number of samples of each pixel with the boxes in the description of its film.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "host/job/film/film_header.h"

namespace candela::film {

/// The samples that a canonical list of boxes has in each column of one row.
class ColumnCounts {
 public:
  struct Count {
    std::uint32_t samples = 0;
    std::uint32_t last = 0;  ///< number of ranges up to the last sample of the render: 0 or 1
  };

  /// `boxes` lie in the window, and must outlive this object. `samplesPerPixel` is that of the render.
  ColumnCounts(std::span<const SampleBox> boxes, const render::Window& window, std::uint32_t samplesPerPixel);

  /// Returns the counts in row `y` of the full image, by column of the window. Rows must be given in ascending order.
  /// All rows together take a time proportional to the number of boxes and of pixels.
  std::span<const Count> at(std::uint32_t y);

 private:
  std::span<const SampleBox> boxes_;  ///< from the next band on
  render::Window window_;
  std::uint32_t samplesPerPixel_;
  std::uint32_t end_ = 0;  ///< first row whose counts may differ
  std::vector<Count> counts_;
};

class CoverageCheck {
 public:
  /// `header` must outlive this object.
  explicit CoverageCheck(const FilmHeader& header);

  /// Throws FileError, without the name of the file, unless every pixel of row `y` of the full image has as many
  /// samples as the header says and no more hits. Rows must be given in ascending order.
  void checkRow(std::uint32_t y, std::span<const image::FilmPixel> row);

 private:
  const FilmHeader& header_;
  ColumnCounts covered_, begun_;
  std::optional<std::uint32_t> pilot_;  ///< samples after which a pixel may have stopped
};

}  // namespace candela::film
