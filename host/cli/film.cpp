// `candela film`: describes a film file, and makes pictures of it.
#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>

#include "host/cli/bias_text.h"
#include "host/cli/commands.h"
#include "host/cli/display_choice.h"
#include "host/cli/film_description.h"
#include "host/cli/json_output.h"
#include "host/cli/option_table.h"
#include "host/cli/output_check.h"
#include "host/core/hash_text.h"
#include "host/film/film_file.h"
#include "host/film/work_report.h"
#include "host/image/false_colour.h"
#include "host/verify/film_test.h"

namespace candela::cli {
namespace {

// The integrator decides how depths and costs are shown.
Arguments withIntegrator(Arguments arguments, const film::FilmHeader& header) {
  const auto integrator = header.settings.find("integrator");
  if (integrator == header.settings.end()) return arguments;
  for (const Option& option : optionTable()) {
    if (option.name() == "--integrator") option.apply(arguments, integrator->second);
  }
  return arguments;
}

image::Image pictureOf(const film::FilmHeader& header, const image::Film& film) {
  image::Image image = toImage(film);
  if (header.hasAlpha()) addAlpha(image, film);
  image.metadata.merge(
      std::map<std::string, std::string>{{"candela.sceneHash", header.sceneHash},
                                         {"candela.filmHash", hashText(film.hash())},
                                         {"candela.samplesPerPixel", fmt::to_string(header.samplesPerPixel)},
                                         {verify::kSeedMetadata, fmt::to_string(header.seed)},
                                         {"candela.interrupted", header.isComplete() ? "no" : "yes"}});
  const auto limit = header.settings.find("clamp-indirect");
  if (limit != header.settings.end() && limit->second != "off")
    image.metadata[verify::kBiasMetadata] = biasText(limit->second);
  return image;
}

void writePictures(const Arguments& arguments, const image::Image& image, const Log& log) {
  const image::DisplayTransform display = chooseDisplay(arguments, image);
  if (isFalseColour(display.toneMap) && std::ranges::any_of(arguments.outputs, image::isEightBit)) {
    log.note(falseColourKey(display));
  }
  for (const auto& file : arguments.outputs) writeImage(file, image, display);
}

}  // namespace

ExitCode runFilm(const Arguments& arguments, const Log& log) {
  for (const auto& file : arguments.outputs) requireWritableImage(file);
  requireWritableReport(arguments.json);
  film::FilmReader reader(arguments.files.front());
  const image::Film film = film::readFilm(reader);
  const FilmDescription description = describe(reader, film);
  if (!arguments.outputs.empty()) {
    writePictures(withIntegrator(arguments, reader.header()), pictureOf(reader.header(), film), log);
  }
  if (arguments.wantsText() && arguments.outputs.empty()) std::cout << toText(description) << std::flush;
  writeJson(arguments.json, toJson(description));
  return ExitCode::done;
}

}  // namespace candela::cli
