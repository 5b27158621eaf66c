// Describes a render in its film file.
#pragma once
#include <cstdint>
#include <span>
#include <string>

#include "host/job/film/film_file.h"
#include "host/job/job.h"

namespace candela::job {

/// One of FilmHeader::settings: a choice that decides the samples, and that no other member of the header states. Its
/// name and its values are those of the option of the same name.
struct FilmSetting {
  const char* name;
  std::string (*value)(const Job& job);
  /// Films do not record this value, because films of versions without the setting have it; null: they record all.
  const char* unrecorded = nullptr;
  bool isFlag = false;  ///< the values are "on" and "off", and the option has none
  /// Text of the default that no value of the option gives; null: there is none, or it is "off" of a flag.
  const char* wordsOfDefault = nullptr;
};
std::span<const FilmSetting> filmSettings();
/// Returns the setting of this name; null if films have none.
const FilmSetting* filmSettingNamed(const std::string& name);

/// Names of further settings of films: "off" if camera rays pass through the pixels' origins, and a description of the
/// acceleration structure, which begins with its kind, of films that show its cost.
inline constexpr const char* kAntialiasing = "antialiasing";
inline constexpr const char* kAccel = "accel";

/// Returns the header of the film of a job, without samples. `statistics` are those of the prepared session.
film::FilmHeader filmHeaderOf(const Job& job, const render::RenderStatistics& statistics);

/// Sets the parts of the header that depend on the samples: the coverage of a film whose pixels hold consecutive
/// samples from `first` on, and the names of its mattes.
void setContent(film::FilmHeader& header, const image::Film& film, const scene::Scene& scene, std::uint32_t first);

}  // namespace candela::job
