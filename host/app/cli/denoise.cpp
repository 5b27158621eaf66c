// `candela denoise`: denoises a film file.
#include <fmt/format.h>

#include "host/app/cli/commands.h"
#include "host/app/cli/denoise_film.h"
#include "host/app/cli/output_check.h"
#include "host/app/cli/render_images.h"
#include "host/base/progress.h"
#include "host/job/film/film_file.h"
#include "host/trace/denoise/oidn.h"
#include "host/trace/denoise/pixel_statistics.h"

namespace candela::cli {
namespace {

// Throws FileError, which names the file, if the film cannot be denoised.
void requireStatisticsOf(const film::FilmReader& reader, const image::Film& film) try {
  denoise::requireStatistics(film);
} catch (const UsageError& error) {
  throw FileError(fmt::format("{}: {}", reader.file().string(), error.what()));
}

}  // namespace

ExitCode run(const DenoiseArguments& arguments, const Log& log) {
  if (arguments.denoisesByOidn) denoise::requireOidn();
  if (arguments.outputs.empty()) throw UsageError("no output given: name an image file with -o FILE");
  for (const auto& file : arguments.outputs) requireWritableImage(file);
  film::FilmReader reader(arguments.files.front());
  const image::Film film = film::readFilm(reader);
  requireStatisticsOf(reader, film);
  const film::FilmHeader& header = reader.header();
  image::Image image = pictureOf(header, film, metadataOf(header, film));
  const double start = monotonicSeconds();
  denoiseImage(image, film, arguments, log);
  log.note(fmt::format("{}x{} pixels denoised in {:.2f} s", film.width(), film.height(), monotonicSeconds() - start));
  writeImages(std::move(image), arguments, integratorOf(header), log);
  return ExitCode::done;
}

}  // namespace candela::cli
