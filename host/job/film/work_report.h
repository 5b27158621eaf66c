// The work that went into a film: counts, times and hosts. They differ from run to run, so that they are kept in a JSON
// file beside the film file and not in it.
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <set>
#include <string>

#include "host/job/film/film_header.h"
#include "host/trace/render/statistics.h"

namespace candela::film {

struct WorkReport {
  std::uint64_t runs = 0;            ///< of the program
  std::uint64_t runsNotCounted = 0;  ///< films, or parts of their work, of which no report was found
  std::set<std::string> hosts;
  std::map<std::string, std::uint64_t> counts;  ///< samples, badSamples, rays by kind, vertices, traversalSteps
  std::map<std::string, double> seconds;        ///< by phase, added up over the runs

  void add(const WorkReport& other);
};

/// The report of one run on this host. Counts of Whitted's tracer are included if it has them.
WorkReport workOf(const render::RenderStatistics& statistics);

/// Returns the content of the file beside a film.
nlohmann::ordered_json toJson(const WorkReport& work);
/// Returns the member `work` of JSON documents.
nlohmann::ordered_json reportJson(const WorkReport& work);

/// The file that belongs to a film file: its name with ".json" appended.
std::filesystem::path workFile(const std::filesystem::path& film);
/// Writes the report of the film file with this check (see FilmReader::check()). Throws FileError.
void writeWork(const std::filesystem::path& film, const std::string& check, const WorkReport& work);
/// The report that is stored beside a film file. Without one, or if it belongs to another film, a report that counts
/// one run that is not counted.
WorkReport readWork(const std::filesystem::path& film, const std::string& check);

}  // namespace candela::film
