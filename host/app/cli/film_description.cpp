// Describes films as text and as JSON.
#include "host/app/cli/film_description.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <nlohmann/json.hpp>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "host/app/cli/adaptive_report.h"
#include "host/app/cli/bad_samples.h"
#include "host/app/cli/option_table.h"
#include "host/app/cli/settings_json.h"
#include "host/base/counted.h"
#include "host/base/hash_text.h"
#include "host/base/report_head.h"
#include "host/job/film_identity.h"

namespace candela::cli {
namespace {

const Option* settingNamed(const std::string& name) { return findOption(Command::render, "--" + name); }

bool isAbsent(const Option& option, const std::string& value) { return value.empty() || option.isDefault(value); }

using nlohmann::ordered_json;

/// Returns the option that gives a setting of FilmHeader::settings its value, e.g. "--max-depth 4" or "--one-sided".
/// Returns nothing if the setting has the default of the option, or if no option gives it.
std::optional<std::string> optionOf(const std::string& name, const std::string& value) {
  if (name == job::kAntialiasing) return value == "off" ? std::optional<std::string>("--spp 0") : std::nullopt;
  const Option* const option = settingNamed(name);
  if (option == nullptr || isAbsent(*option, value)) return std::nullopt;
  if (option->isFlag()) return option->name();
  Arguments scratch = RenderArguments();
  if (!option->apply(scratch, value)) return std::nullopt;
  return fmt::format("{} {}", option->name(), shellQuoted(value));
}

/// Returns the settings of a film as reports of renders have them: see settingValue().
ordered_json settingsJson(const std::map<std::string, std::string>& settings) {
  ordered_json json = ordered_json::object();
  for (const auto& [name, value] : settings) {
    const Option* const option = settingNamed(name);
    ordered_json& member = json[settingKey(name)];
    if (name == job::kAntialiasing) {
      member = value != "off";
    } else if (option == nullptr) {
      member = value;
    } else {
      const bool isUnset = option->isFlag() && option->isDefault(value);
      member = settingValue(*option, isUnset ? std::vector<std::string>{} : std::vector{value});
    }
  }
  return json;
}

std::vector<std::string> textsOf(const std::vector<film::SampleBox>& boxes) {
  std::vector<std::string> texts;
  for (const film::SampleBox& box : boxes) texts.push_back(boxText(box));
  return texts;
}

std::string row(const std::string& name, const std::string& value) { return fmt::format("{:<16} {}\n", name, value); }

std::string rows(const std::string& name, const std::vector<std::string>& values) {
  std::string text;
  for (const std::string& value : values) text += row(text.empty() ? name : "", value);
  return text;
}

// Returns the settings as options for a shell, without those that have their defaults.
std::string settingsText(const std::map<std::string, std::string>& settings) {
  std::vector<std::string> options;
  for (const auto& [name, value] : settings) {
    if (const std::optional<std::string> option = optionOf(name, value)) options.push_back(*option);
  }
  return options.empty() ? "all at their defaults" : fmt::format("{}", fmt::join(options, " "));
}

std::vector<std::string> tracerTexts(const std::vector<film::Tracer>& tracers) {
  std::vector<std::string> texts;
  for (const film::Tracer& tracer : tracers) {
    texts.push_back(fmt::format("{}{}{} (candela {})", tracer.device, tracer.driver.empty() ? "" : ", ", tracer.driver,
                                tracer.program));
  }
  return texts;
}

render::BadSampleTally badSamplesOf(const film::FilmHeader& header, const image::Film& film) {
  render::ImageSettings image;
  image.size = header.size;
  image.crop = header.window;
  image.seed = header.seed;
  image.sampleCount = header.samplesPerPixel;
  render::BadSampleTally tally;
  tally.add(film, image);
  return tally;
}

}  // namespace

FilmDescription describe(const film::FilmHeader& header, const image::Film& film, const film::WorkReport& work) {
  FilmDescription description{header, hashText(film.hash()), film.counts().samples, badSamplesOf(header, film), {},
                              work};
  if (const auto plan = planOf(header)) {
    description.adaptive = adaptiveText(film);
    description.adaptiveFigures = adaptiveJson(*plan, film, header.samplesPerPixel);
  }
  std::vector<film::SampleBox> boxes = header.covered;
  boxes.insert(boxes.end(), header.begun.begin(), header.begun.end());
  description.missing = missingBoxes(boxes, {render::windowOf(header.size), {0, header.samplesPerPixel}});
  return description;
}

FilmDescription describe(const film::FilmReader& reader, const image::Film& film) {
  return describe(reader.header(), film, film::readWork(reader.file(), reader.check()));
}

std::string toText(const FilmDescription& description) {
  const film::FilmHeader& header = description.header;
  std::string text = row("scene", header.sceneHash);
  text += row("image", fmt::format("{} pixels, {} per pixel, seed {}", render::extentText(header.size),
                                   counted(header.samplesPerPixel, "sample"), header.seed));
  text += row("settings", settingsText(header.settings));
  if (!header.layers.isEmpty()) text += row("layers", layerText(header.layers));
  text += rows("contains", textsOf(header.covered));
  text += rows("interrupted in", textsOf(header.begun));
  text += rows("missing", textsOf(description.missing));
  text += row("samples", fmt::to_string(description.samples));
  if (description.adaptive) text += row("adaptive", *description.adaptive);
  text += row("bad samples", fmt::to_string(description.badSamples.samples()));
  text += rows("rendered by", tracerTexts(header.tracers));
  text += rows("mixed", header.mixed);
  text += row("film hash", description.filmHash);
  if (description.work.runs > 0) {
    text += row("work",
                fmt::format("{}, {:.1f} s of tracing", counted(description.work.runs, "run"),
                            description.work.seconds.contains("trace") ? description.work.seconds.at("trace") : 0.0));
  }
  return text;
}

ordered_json toJson(const FilmDescription& description) {
  const film::FilmHeader& header = description.header;
  ordered_json json = reportHead("candela-film/1");
  json.update({{"sceneHash", header.sceneHash},
               {"size", render::extentText(header.size)},
               {"samplesPerPixel", header.samplesPerPixel},
               {"seed", header.seed},
               {"settings", settingsJson(header.settings)},
               {"layers", layerText(header.layers)},
               {"window", render::windowText(header.window)},
               {"complete", header.isComplete()},
               {"covered", textsOf(header.covered)},
               {"interrupted", !header.begun.empty()},
               {"begun", textsOf(header.begun)},
               {"missing", textsOf(description.missing)},
               {"samples", description.samples},
               {"badSamples", badSamplesJson(description.badSamples)},
               {"tracers", film::tracersJson(header.tracers)},
               {"mixed", header.isMixed()},
               {"ignoredDifferences", header.mixed},
               {"filmHash", description.filmHash},
               {"work", film::reportJson(description.work)}});
  if (description.adaptive) json["adaptive"] = description.adaptiveFigures;
  return json;
}

}  // namespace candela::cli
