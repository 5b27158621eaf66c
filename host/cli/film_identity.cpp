// Collects the settings and the tracer of a render.
#include "host/cli/film_identity.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "host/cli/option_table.h"
#include "host/core/errors.h"
#include "host/core/hash_text.h"
#include "host/core/utf8.h"
#include "host/core/version.h"
#include "host/scene/object_names.h"

namespace candela::cli {
namespace {

// Size, samples and seed are members of the header. The folders that files may be in do not change what is read, the
// scene's hash covers the environment, and the scale in use is a setting of its own.
bool isSetting(const Option& option) {
  const bool decides = option.group == OptionGroup::image || option.group == OptionGroup::sceneFile;
  const std::string name = option.name();
  const bool stated = name == "--size" || name == "--spp" || name == "--seed" || name == "--allow-path" ||
                      name == "--env" || name == "--film-scale";
  return decides && !stated && option.isFor(Command::render);
}

// Films of earlier versions call the list of a small scene "row".
const char* layoutText(render::LayoutInUse layout) {
  return layout == render::LayoutInUse::list ? "row" : nameOf(layout);
}

std::string structureText(const RenderJob& job, const render::RenderStatistics& statistics) {
  return fmt::format("{} {} {} {} density {}", nameOf(statistics.structure), nameOf(statistics.bvhSplit),
                     nameOf(statistics.bvhQuality), layoutText(statistics.layout), job.settings.structure.gridDensity);
}

// Films of versions without these options can be resumed, because films record these options only if they do not
// have their defaults.
constexpr std::array<std::string_view, 4> kLateSettings{"--background", "--noise-threshold", "--aov-through-specular",
                                                        "--animation"};

std::map<std::string, std::string> settingsOf(const RenderJob& job, const render::RenderStatistics& statistics) {
  std::map<std::string, std::string> settings;
  for (const Option& option : optionTable()) {
    if (!isSetting(option)) continue;
    const std::vector<std::string> values = option.show(job.arguments);
    const std::string value = values.empty() ? "off" : values.front();
    const bool isLate = std::ranges::find(kLateSettings, option.name()) != kLateSettings.end();
    if (isLate && option.isDefault(value)) continue;
    settings[option.name().substr(2)] = validUtf8(value);
  }
  if (job.arguments.noiseThreshold) settings[film::kStoppingRule] = film::kCurrentStoppingRule;
  if (job.settings.image.filmScale > 0) settings[film::kFilmScale] = fmt::to_string(job.settings.image.filmScale);
  if (!job.settings.image.antialiasing) settings["antialiasing"] = "off";
  if (job.settings.image.integrator == render::Integrator::cost) settings["accel"] = structureText(job, statistics);
  return settings;
}

}  // namespace

film::FilmHeader filmHeaderOf(const RenderJob& job, const render::RenderStatistics& statistics) {
  film::FilmHeader header;
  header.sceneHash = hashText(job.scene.hash);
  header.size = job.settings.image.size;
  header.samplesPerPixel = job.settings.image.sampleCount;
  header.seed = job.settings.image.seed;
  header.settings = settingsOf(job, statistics);
  header.layers = withSums(job.settings.image.layers);
  header.window = job.settings.image.window();
  header.tracers = {{validUtf8(statistics.device), validUtf8(statistics.driver), statistics.platform,
                     statistics.kernels, versionText()}};
  return header;
}

void setContent(film::FilmHeader& header, const image::Film& film, const scene::Scene& scene, std::uint32_t first) {
  setCoverage(header, film, first);
  header.matteNames = matteNamesOf(scene, film);
}

render::SampleRange samplesOf(const RenderJob& job) {
  const std::uint32_t total = job.settings.image.sampleCount;
  const render::SampleRange range = job.arguments.samples.value_or(render::SampleRange{0, total});
  if (range.end <= total) return range;
  throw UsageError(fmt::format("--samples {}:{} exceeds the {} samples per pixel; set the total with --spp",
                               range.first, range.end, total));
}

}  // namespace candela::cli
