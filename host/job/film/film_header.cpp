// Coverage of a film, and the settings that its header names.
#include "host/job/film/film_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "host/base/errors.h"
#include "host/trace/render/film_coverage.h"

namespace candela::film {
namespace {

constexpr const char* kThresholdSetting = "noise-threshold";

// The samples from `first` to `end`, unless there are none.
std::vector<SampleBox> boxOf(const render::Window& window, std::uint32_t first, std::uint32_t end) {
  if (first == end) return {};
  return {{window, {first, end}}};
}

// Sets the coverage of an adaptively sampled film. Its pixels alone determine whether it is finished.
void setAdaptiveCoverage(FilmHeader& header, const image::Film& film, const render::AdaptivePlan& plan) {
  const bool isFinished = !plan.next(film);
  const std::uint32_t end = isFinished ? header.samplesPerPixel : render::minSampleCount(film.pixels());
  header.covered = boxOf(header.window, 0, end);
  header.begun = boxOf(header.window, end, header.samplesPerPixel);
}

}  // namespace

bool FilmHeader::isComplete() const {
  return covered == std::vector{SampleBox{render::windowOf(size), {0, samplesPerPixel}}};
}

std::uint32_t FilmHeader::format() const {
  if (settings.contains(kFilmScale)) return 7;
  if (settings.contains(kStoppingRule)) return 6;
  if (hasMattes(layers)) return 5;
  if (settings.contains(kThresholdSetting)) return 4;
  if (!layers.isEmpty()) return 3;
  return hasAlpha() ? 2 : 1;
}

std::string FilmHeader::setting(const std::string& name) const {
  const auto found = settings.find(name);
  return found == settings.end() ? "" : found->second;
}

bool FilmHeader::hasAlpha() const { return setting("background") == "none"; }

std::optional<double> FilmHeader::noiseThreshold() const {
  const auto found = settings.find(kThresholdSetting);
  if (found == settings.end()) return std::nullopt;
  const std::string& text = found->second;
  double threshold = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), threshold);
  if (error == std::errc() && end == text.data() + text.size() && threshold > 0) return threshold;
  throw FileError("the noise threshold of the film is not a number above 0");
}

std::uint32_t FilmHeader::filmScale() const {
  const auto found = settings.find(kFilmScale);
  if (found == settings.end()) return 0;
  for (std::uint32_t scale = 1; scale <= image::kMaxFilmScale; ++scale) {
    if (found->second == fmt::to_string(scale)) return scale;
  }
  throw FileError(fmt::format("the scale of the film is not a whole number from 1 to {}", image::kMaxFilmScale));
}

bool FilmHeader::hasFirstStoppingRule() const {
  return settings.contains(kThresholdSetting) && !settings.contains(kStoppingRule);
}

std::optional<render::AdaptivePlan> planOf(const FilmHeader& header) {
  const std::optional<double> threshold = header.noiseThreshold();
  if (!threshold || header.hasFirstStoppingRule()) return std::nullopt;
  return render::AdaptivePlan(header.window, *threshold, header.samplesPerPixel);
}

void setCoverage(FilmHeader& header, const image::Film& film, std::uint32_t first) {
  if (const auto plan = planOf(header)) {
    setAdaptiveCoverage(header, film, *plan);
    return;
  }
  const auto [min, max] = std::ranges::minmax(film.pixels(), {}, &image::FilmPixel::sampleCount);
  header.covered = boxOf(header.window, first, first + min.sampleCount);
  header.begun = boxOf(header.window, first + min.sampleCount, first + max.sampleCount);
}

std::optional<std::uint32_t> firstSampleOf(const FilmHeader& header) {
  if (header.covered.size() > 1 || header.begun.size() > 1) return std::nullopt;
  const SampleBox* const covered = header.covered.empty() ? nullptr : &header.covered.front();
  const SampleBox* const begun = header.begun.empty() ? nullptr : &header.begun.front();
  if (covered != nullptr && covered->window != header.window) return std::nullopt;
  if (begun != nullptr && begun->window != header.window) return std::nullopt;
  if (covered != nullptr && begun != nullptr && covered->samples.end != begun->samples.first) return std::nullopt;
  if (covered != nullptr) return covered->samples.first;
  if (begun != nullptr) return begun->samples.first;
  return std::nullopt;
}

}  // namespace candela::film
