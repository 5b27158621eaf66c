// The table of the settings that decide the samples of a film, and the tracer that adds them.
#include "host/job/film_identity.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "host/base/hash_text.h"
#include "host/base/utf8.h"
#include "host/base/version.h"
#include "host/scene/object_names.h"
#include "host/trace/render/choices_in_use.h"

namespace candela::job {
namespace {

template <class T>
std::string textOr(const std::optional<T>& value, const char* absent) {
  return value ? fmt::to_string(*value) : absent;
}

constexpr const char* kFirstOrNone = "the first, else none";
constexpr const char* kAtRest = "the pose at rest";
constexpr const char* kFirst = "the first";

std::string onOff(bool value) { return value ? "on" : "off"; }

const render::ImageSettings& imageOf(const Job& job) { return job.settings.image; }

// Films of earlier versions call the list of a small scene "row".
const char* layoutText(render::LayoutInUse layout) {
  return layout == render::LayoutInUse::list ? "row" : nameOf(layout);
}

std::string structureText(const Job& job, const render::RenderStatistics& statistics) {
  return fmt::format("{} {} {} {} density {}", nameOf(statistics.structure), nameOf(statistics.bvhSplit),
                     nameOf(statistics.bvhQuality), layoutText(statistics.layout), job.settings.structure.gridDensity);
}

std::map<std::string, std::string> settingsOf(const Job& job, const render::RenderStatistics& statistics) {
  std::map<std::string, std::string> settings;
  for (const FilmSetting& setting : filmSettings()) {
    const std::string text = setting.value(job);
    if (setting.unrecorded == nullptr || text != setting.unrecorded) settings[setting.name] = validUtf8(text);
  }
  if (job.film.noiseThreshold) settings[film::kStoppingRule] = film::kCurrentStoppingRule;
  if (imageOf(job).filmScale > 0) settings[film::kFilmScale] = fmt::to_string(imageOf(job).filmScale);
  if (!imageOf(job).antialiasing) settings[kAntialiasing] = "off";
  if (imageOf(job).integrator == render::Integrator::cost) settings[kAccel] = structureText(job, statistics);
  return settings;
}

}  // namespace

// The folders that files may be in do not change what is read, and the scene's hash covers the environment.
std::span<const FilmSetting> filmSettings() {
  static constexpr std::array kSettings{
      FilmSetting{"max-depth", [](const Job& job) { return fmt::to_string(imageOf(job).maxDepth); }},
      FilmSetting{"rr-start", [](const Job& job) { return fmt::to_string(imageOf(job).rouletteStart); }},
      FilmSetting{"integrator", [](const Job& job) -> std::string { return nameOf(imageOf(job).integrator); }},
      FilmSetting{"ao-distance", [](const Job& job) { return textOr(imageOf(job).aoDistance, "auto"); }},
      FilmSetting{"nee", [](const Job& job) { return onOff(imageOf(job).nextEventEstimation); }},
      FilmSetting{"lights", [](const Job& job) -> std::string { return nameOf(imageOf(job).lights); }, "power"},
      FilmSetting{"sampler", [](const Job& job) -> std::string { return nameOf(imageOf(job).sampler); }},
      FilmSetting{"filter", [](const Job& job) { return render::filterText(imageOf(job).filter); }},
      FilmSetting{"lens", [](const Job& job) -> std::string { return nameOf(imageOf(job).lens); }},
      FilmSetting{"pixel-origin", [](const Job& job) -> std::string { return nameOf(imageOf(job).pixelOrigin); }},
      FilmSetting{"light-size", [](const Job& job) { return fmt::to_string(imageOf(job).lightSize); }},
      FilmSetting{"clamp-indirect", [](const Job& job) { return textOr(imageOf(job).indirectLimit, "off"); }},
      FilmSetting{"background", [](const Job& job) -> std::string { return nameOf(imageOf(job).backdrop); }, "env"},
      FilmSetting{"aov-through-specular", [](const Job& job) { return onOff(imageOf(job).layersThroughSpecular); },
                  "off", true},
      FilmSetting{"noise-threshold", [](const Job& job) { return textOr(job.film.noiseThreshold, "off"); }, "off"},
      FilmSetting{"one-sided", [](const Job& job) { return onOff(imageOf(job).oneSided); }, nullptr, true},
      FilmSetting{"lenient", [](const Job& job) { return onOff(job.reading.lenient); }, nullptr, true},
      FilmSetting{"env-rotate", [](const Job& job) { return fmt::to_string(job.reading.environment.rotation); }},
      FilmSetting{"env-scale", [](const Job& job) { return fmt::to_string(job.reading.environment.scale); }},
      FilmSetting{"camera", [](const Job& job) { return textOr(job.reading.camera, kFirstOrNone); }, nullptr, false,
                  kFirstOrNone},
      FilmSetting{"time", [](const Job& job) { return textOr(job.reading.time, kAtRest); }, nullptr, false, kAtRest},
      FilmSetting{"animation", [](const Job& job) { return textOr(job.reading.animation, kFirst); }, kFirst, false,
                  kFirst},
      FilmSetting{"orbit", [](const Job& job) { return fmt::to_string(job.reading.orbit); }, "0"}};
  return kSettings;
}

const FilmSetting* filmSettingNamed(const std::string& name) {
  const auto found = std::ranges::find_if(filmSettings(), [&](const FilmSetting& one) { return one.name == name; });
  return found == filmSettings().end() ? nullptr : &*found;
}

film::FilmHeader filmHeaderOf(const Job& job, const render::RenderStatistics& statistics) {
  film::FilmHeader header;
  header.sceneHash = hashText(job.scene().hash);
  header.size = imageOf(job).size;
  header.samplesPerPixel = imageOf(job).sampleCount;
  header.seed = imageOf(job).seed;
  header.settings = settingsOf(job, statistics);
  header.layers = withSums(imageOf(job).layers);
  header.window = imageOf(job).window();
  header.tracers = {{validUtf8(statistics.device), validUtf8(statistics.driver), statistics.platform,
                     statistics.kernels, versionText()}};
  return header;
}

void setContent(film::FilmHeader& header, const image::Film& film, const scene::Scene& scene, std::uint32_t first) {
  setCoverage(header, film, first);
  header.matteNames = matteNamesOf(scene, film);
}

}  // namespace candela::job
