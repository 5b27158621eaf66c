// The report of `candela film` and `candela merge` about a film file.
#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host/job/film/film_file.h"
#include "host/job/film/work_report.h"
#include "host/trace/render/bad_sample_tally.h"

namespace candela::cli {

struct FilmDescription {
  film::FilmHeader header;
  std::string filmHash;
  std::uint64_t samples = 0;  ///< in the film
  render::BadSampleTally badSamples;
  std::vector<film::SampleBox> missing;  ///< of the image
  film::WorkReport work;
  std::optional<std::string> adaptive{};     ///< statistics of adaptive sampling, as text
  nlohmann::ordered_json adaptiveFigures{};  ///< see adaptiveJson()
};

FilmDescription describe(const film::FilmHeader& header, const image::Film& film, const film::WorkReport& work);
/// Includes the report of the work beside the file.
FilmDescription describe(const film::FilmReader& reader, const image::Film& film);

std::string toText(const FilmDescription& description);
nlohmann::ordered_json toJson(const FilmDescription& description);

}  // namespace candela::cli
