// Film files: a film with everything that identifies it, exactly, in an OpenEXR file that other programs open as a
// picture. docs/film-file.md is the specification.
#pragma once
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "host/image/film.h"
#include "host/job/film/film_header.h"

namespace candela::film {

class FilmBlocks;

/// Writes a film file as AtomicFile does: equal headers and films give equal bytes. The film has the size of
/// header.window. Returns the file's check, 8 hexadecimal digits that change with every byte. Throws FileError.
std::string writeFilm(const std::filesystem::path& file, const FilmHeader& header, const image::Film& film);

/// Full rows of a film.
struct FilmRows {
  std::uint32_t first;  ///< index of the first row within the window of the film
  std::span<const image::FilmPixel> pixels;
  std::span<const image::LayerRow> layerRows;  ///< as Film::layerRows()
  /// The counts of Film::ids(), by MatteKind.
  std::array<std::span<const image::IdCounts>, image::kMatteKinds.size()> ids{};
};

/// A film file that is open for reading. All functions throw FileError, which names the file, for any file that
/// writeFilm() did not write: not a film, truncated, damaged, beyond the limits of image sizes, or of another version.
class FilmReader {
 public:
  /// Reads everything but the pixels. The file is checked before OpenEXR reads a byte of it.
  explicit FilmReader(const std::filesystem::path& file);
  ~FilmReader();
  FilmReader(FilmReader&&) noexcept;

  const std::filesystem::path& file() const { return file_; }
  const FilmHeader& header() const { return header_; }
  /// The digits that writeFilm() returned.
  const std::string& check() const { return check_; }
  /// Passes all pixels, blocks of full rows from the top.
  void forEachBlock(const std::function<void(const FilmRows&)>& use);

 private:
  std::filesystem::path file_;
  FilmHeader header_;
  std::string check_;
  std::unique_ptr<FilmBlocks> blocks_;
};

/// All pixels of a film file. Throws FileError as FilmReader does, and OutOfMemoryError.
image::Film readFilm(FilmReader& reader);

}  // namespace candela::film
