// `candela film`: describes a film file, and makes pictures of it.
#include <iostream>
#include <nlohmann/json.hpp>

#include "host/cli/commands.h"
#include "host/cli/film_description.h"
#include "host/cli/json_output.h"
#include "host/cli/output_check.h"
#include "host/cli/render_images.h"
#include "host/cli/text_output.h"
#include "host/film/film_file.h"

namespace candela::cli {

ExitCode run(const FilmArguments& arguments, const Log& log) {
  for (const auto& file : arguments.outputs) requireWritableImage(file);
  requireWritableReport(arguments.json);
  film::FilmReader reader(arguments.files.front());
  const image::Film film = film::readFilm(reader);
  const FilmDescription description = describe(reader, film);
  if (!arguments.outputs.empty()) {
    const film::FilmHeader& header = reader.header();
    writeImages(pictureOf(header, film, metadataOf(header, film)), arguments, integratorOf(header), log);
  }
  if (wantsText(arguments, {arguments.json}) && arguments.outputs.empty())
    std::cout << toText(description) << std::flush;
  writeJson(arguments.json, toJson(description));
  return ExitCode::done;
}

}  // namespace candela::cli
