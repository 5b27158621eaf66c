// `candela film`: describes a film file, and makes pictures of it.
#include <iostream>
#include <nlohmann/json.hpp>

#include "host/app/cli/commands.h"
#include "host/app/cli/film_description.h"
#include "host/app/cli/json_output.h"
#include "host/app/cli/output_check.h"
#include "host/app/cli/render_images.h"
#include "host/app/cli/text_output.h"
#include "host/job/film/film_file.h"

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
