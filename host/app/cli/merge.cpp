// `candela merge`: merges films of parts of a render.
#include "host/job/film/merge.h"

#include <fmt/format.h>

#include <iostream>
#include <nlohmann/json.hpp>

#include "host/app/cli/commands.h"
#include "host/app/cli/film_description.h"
#include "host/app/cli/json_output.h"
#include "host/app/cli/output_check.h"
#include "host/base/counted.h"

namespace candela::cli {

ExitCode run(const MergeArguments& arguments, const Log& log) {
  requireWritableFilm(arguments.output);
  requireWritableReport(arguments.json);
  const film::FilmLock lock(arguments.output);
  const std::vector<std::filesystem::path> files(arguments.files.begin(), arguments.files.end());
  const film::MergedFilm merged = film::mergeFilms(files, {arguments.mixedDevices, arguments.partial});
  const std::string check = film::writeFilm(arguments.output, merged.header, merged.film);
  film::writeWork(arguments.output, check, merged.work);
  const FilmDescription description = describe(merged.header, merged.film, merged.work);
  for (const film::SampleBox& box : description.missing) log.warning(boxText(box) + " are missing");
  for (const film::SampleBox& box : merged.header.begun) log.warning(boxText(box) + " are incomplete");
  if (merged.header.isMixed())
    log.warning("the films come from different devices or settings; the merged film is marked as mixed");
  log.note(fmt::format("{} merged, {}{}", counted(files.size(), "film"), counted(description.samples, "sample"),
                       merged.header.isComplete() ? "; the image is complete" : ""));
  writeJson(arguments.json, toJson(description));
  return ExitCode::done;
}

}  // namespace candela::cli
