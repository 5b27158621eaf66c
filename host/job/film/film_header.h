// The description of a film in its file: everything that decides its bytes, and nothing else.
#pragma once
#include <cstdint>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/image/film.h"
#include "host/job/film/sample_boxes.h"
#include "host/trace/render/adaptive_plan.h"

namespace candela::film {

/// Name and value of the setting of adaptively sampled films that states the rule by which regions stop. Films of the
/// first rule lack it: they can be read, but not be resumed or merged.
inline constexpr const char* kStoppingRule = "stopping-rule";
inline constexpr const char* kCurrentStoppingRule = "2";
/// Name of the setting with the scale of a film, as a whole number; films of scale 0 lack it.
inline constexpr const char* kFilmScale = "film-scale";

/// A program and a device that traced samples. Films of equal tracers and equal samples have equal bytes. Nothing here
/// names one machine: devices of one kind are equal.
struct Tracer {
  std::string device;    ///< name, or "cpu" for the reference
  std::string driver;    ///< name and version; empty for the reference
  std::string platform;  ///< render::RenderStatistics::platform
  std::string kernels;   ///< render::RenderStatistics::kernels
  std::string program;   ///< version of Candela

  auto operator<=>(const Tracer&) const = default;
};

/// All texts are valid UTF-8: validUtf8() of names that may contain other bytes.
struct FilmHeader {
  std::string sceneHash;              ///< 16 hexadecimal digits
  render::Extent size;                ///< of the full image
  std::uint32_t samplesPerPixel = 1;  ///< of the whole render; the film may contain only a part of them
  std::uint32_t seed = 0;
  std::map<std::string, std::string> settings;  ///< other options that decide the image, by name without dashes
  image::LayerSet layers;                       ///< those with sums, see image::withSums()
  image::MatteNames matteNames;                 ///< of all ids that the pixels have
  /// By MatteKind: the largest number of ids of a pixel. writeFilm() sets it.
  std::array<std::uint32_t, image::kMatteKinds.size()> matteSlots{};
  render::Window window;           ///< pixels of the full image that the film has
  std::vector<SampleBox> covered;  ///< samples that the film contains, as canonicalBoxes() lists them
  /// Boxes that were interrupted: each of their pixels has the first of these samples, possibly none, but not all of
  /// them. Disjoint from `covered`, in the same order.
  std::vector<SampleBox> begun;
  std::vector<Tracer> tracers;     ///< sorted, each once; one unless films of different devices were merged
  std::vector<std::string> mixed;  ///< differences that the user chose to ignore, sorted, each once

  /// Returns the value of one of `settings`; empty if the film lacks it.
  std::string setting(const std::string& name) const;
  /// Returns whether the film has hit counts, as the setting `background` determines.
  bool hasAlpha() const;
  /// Threshold of adaptive sampling, from the setting `noise-threshold`. Throws FileError if that is no number.
  std::optional<double> noiseThreshold() const;
  /// Returns whether the film was sampled adaptively by the first rule.
  bool hasFirstStoppingRule() const;
  /// Scale of the film, from the setting `film-scale`; 0 without it. Throws FileError if that is no number from 1 to
  /// kMaxFilmScale in its shortest notation.
  std::uint32_t filmScale() const;
  bool isMixed() const { return tracers.size() > 1 || !mixed.empty(); }
  /// Returns whether every pixel of the image has all samples.
  bool isComplete() const;
  /// Version of the format of its file: 7 with a scale, 6 with a rule of stopping, 5 with mattes, 4 with a noise
  /// threshold and the first rule, 3 with other layers, 2 with alpha only, else 1.
  std::uint32_t format() const;
  bool operator==(const FilmHeader&) const = default;
};

/// Returns the plan by which a film is sampled adaptively; nothing without a noise threshold, and for films of the
/// first rule. Throws as noiseThreshold() does.
std::optional<render::AdaptivePlan> planOf(const FilmHeader& header);

/// Sets `covered` and `begun` of a film whose pixels hold consecutive samples from `first` on. An adaptively sampled
/// film that is finished covers all samples, although not every pixel has them.
void setCoverage(FilmHeader& header, const image::Film& film, std::uint32_t first);

/// Returns the index of the first sample of each pixel of a film that a session can continue: all pixels of the window
/// hold consecutive samples from that index on. Nothing for a film without samples and for one that was merged from
/// parts which do not form such a film.
std::optional<std::uint32_t> firstSampleOf(const FilmHeader& header);

/// The differences of two films, or of a film and a render, in scene, image, settings and layers, each as a clause such
/// as "sampler is sobol in A and stratified in B", with the name of settingWords(). `a` and `b` are their names in the
/// clauses.
std::vector<std::string> estimateDifferences(const FilmHeader& inA, const FilmHeader& inB, const std::string& a,
                                             const std::string& b);
/// Returns the same clauses for FilmHeader::mixed of a film whose parts differ.
std::vector<std::string> mixedDifferences(const FilmHeader& earlier, const FilmHeader& later);
/// Returns the differences of two tracers.
std::vector<std::string> tracerDifferences(const Tracer& inA, const Tracer& inB, const std::string& a,
                                           const std::string& b);

/// Canonical JSON: equal headers have equal texts.
std::string toJson(const FilmHeader& header);
/// Throws FileError for any text that is not the text of a valid header by toJson().
FilmHeader headerFromJson(const std::string& text);
/// Returns the member `tracers` of that text.
nlohmann::ordered_json tracersJson(const std::vector<Tracer>& tracers);

}  // namespace candela::film
