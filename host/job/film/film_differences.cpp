// Differences between two films, or between a film and a render.
#include <fmt/format.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "host/base/setting_words.h"
#include "host/job/film/film_header.h"

namespace candela::film {
namespace {

std::string clause(const std::string& what, const std::string& inA, const std::string& inB, const std::string& a,
                   const std::string& b) {
  return fmt::format("{} is {} in {} and {} in {}", what, inA.empty() ? "absent" : inA, a, inB.empty() ? "absent" : inB,
                     b);
}

using Members = std::vector<std::pair<std::string, std::string>>;

// Some settings have no option of their name: --spp 0 turns antialiasing off, and `accel` describes the structure.
std::pair<std::string, std::string> memberOf(const std::string& name, const std::string& value, SettingWords words) {
  if (name == "antialiasing") return {name, value.empty() ? "on" : value};
  if (name == "accel") return {"the acceleration structure", value};
  return {words(name, ""), value};
}

// Names and values of all members that must be equal in two films of one estimate, in the order in which they are
// compared.
Members estimateOf(const FilmHeader& header, const FilmHeader& other, SettingWords words) {
  Members members{{"the scene's hash", header.sceneHash},
                  {words("size", ""), render::extentText(header.size)},
                  {words("spp", ""), fmt::to_string(header.samplesPerPixel)},
                  {words("seed", ""), fmt::to_string(header.seed)}};
  std::map<std::string, std::string> names = header.settings;
  names.insert(other.settings.begin(), other.settings.end());
  // The integrator comes first, since others may differ because of it.
  members.emplace_back(words("integrator", ""), header.setting("integrator"));
  for (const auto& [name, value] : names) {
    if (name != "integrator") members.push_back(memberOf(name, header.setting(name), words));
  }
  members.emplace_back(words("aov", ""), image::layerText(header.layers));
  return members;
}

Members membersOf(const Tracer& tracer) {
  return {{"the device", tracer.device},
          {"the driver", tracer.driver},
          {"the platform", tracer.platform},
          {"the hash of the kernels", tracer.kernels},
          {"the program's version", tracer.program}};
}

std::vector<std::string> differences(const Members& inA, const Members& inB, const std::string& a,
                                     const std::string& b) {
  std::vector<std::string> clauses;
  for (std::size_t i = 0; i < inA.size(); ++i) {
    if (inA[i] != inB[i]) clauses.push_back(clause(inA[i].first, inA[i].second, inB[i].second, a, b));
  }
  return clauses;
}

}  // namespace

std::vector<std::string> estimateDifferences(const FilmHeader& inA, const FilmHeader& inB, const std::string& a,
                                             const std::string& b) {
  return differences(estimateOf(inA, inB, &settingWords), estimateOf(inB, inA, &settingWords), a, b);
}

// Film files name settings as the command line does, whoever writes them.
std::vector<std::string> mixedDifferences(const FilmHeader& earlier, const FilmHeader& later) {
  const SettingWords words = [](std::string_view name, std::string_view) { return "--" + std::string(name); };
  return differences(estimateOf(earlier, later, words), estimateOf(later, earlier, words), "an earlier part",
                     "a later part");
}

std::vector<std::string> tracerDifferences(const Tracer& inA, const Tracer& inB, const std::string& a,
                                           const std::string& b) {
  return differences(membersOf(inA), membersOf(inB), a, b);
}

}  // namespace candela::film
