// Describes images, and writes them.
#include "host/app/cli/render_images.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "host/app/cli/adaptive_report.h"
#include "host/app/cli/bias_text.h"
#include "host/app/cli/display_choice.h"
#include "host/app/cli/notation.h"
#include "host/app/cli/option_table.h"
#include "host/app/view/camera_text.h"
#include "host/base/errors.h"
#include "host/base/hash_text.h"
#include "host/base/standard_output.h"
#include "host/base/version.h"
#include "host/image/cryptomatte.h"
#include "host/image/false_colour.h"
#include "host/judge/verify/film_test.h"
#include "host/scene/object_names.h"

namespace candela::cli {
namespace {

void addMatteMetadata(image::LayerSet layers, const image::MatteNames& names, Metadata& metadata) {
  for (const image::MatteKind kind : image::kMatteKinds) {
    if (hasMatte(layers, kind)) metadata.merge(cryptomatteMetadata(kind, names[static_cast<std::size_t>(kind)]));
  }
}

}  // namespace

Metadata metadataOf(const RenderJob& job, const render::RenderResult& result) {
  const render::RenderStatistics& statistics = result.statistics;
  const RenderArguments stated = statedArguments(job);
  std::string settings = commandLineOf(stated, OptionGroup::image, false);
  const std::string reading = commandLineOf(stated, OptionGroup::sceneFile, true);
  if (!reading.empty()) settings += " " + reading;
  Metadata metadata{{"candela.version", versionText()},
                    {"candela.scene", job.scene().name},
                    {"candela.sceneHash", hashText(job.scene().hash)},
                    {"candela.filmHash", hashText(result.film.hash())},
                    {"candela.samplesPerPixel", fmt::to_string(job.settings.image.sampleCount)},
                    {verify::kSeedMetadata, fmt::to_string(job.settings.image.seed)},
                    {"candela.device", statistics.device},
                    {"candela.driver", statistics.driver},
                    {"candela.settings", settings},
                    {"candela.interrupted", result.interrupted ? "yes" : "no"}};
  if (job.settings.image.crop) metadata["candela.crop"] = windowText(*job.settings.image.crop);
  if (const auto& range = job.film.samples) {
    metadata["candela.samples"] = fmt::format("{}:{}", range->first, range->end);
  }
  addMatteMetadata(job.settings.image.layers, matteNamesOf(job.scene(), result.film), metadata);
  if (job.settings.image.indirectLimit) addBias(metadata, biasText(*job.settings.image.indirectLimit));
  if (const auto& threshold = job.film.noiseThreshold) addBias(metadata, adaptiveBiasText(fmt::to_string(*threshold)));
  return metadata;
}

Metadata metadataOf(const film::FilmHeader& header, const image::Film& film) {
  Metadata metadata{{"candela.sceneHash", header.sceneHash},
                    {"candela.filmHash", hashText(film.hash())},
                    {"candela.samplesPerPixel", fmt::to_string(header.samplesPerPixel)},
                    {verify::kSeedMetadata, fmt::to_string(header.seed)},
                    {"candela.interrupted", header.isComplete() ? "no" : "yes"}};
  addMatteMetadata(header.layers, header.matteNames, metadata);
  const std::string limit = header.setting("clamp-indirect"), threshold = header.setting("noise-threshold");
  if (!limit.empty() && limit != "off") addBias(metadata, biasText(limit));
  if (!threshold.empty()) addBias(metadata, adaptiveBiasText(threshold));
  return metadata;
}

void addMovedCamera(const scene::Camera& camera, const scene::Camera& ofFile, Metadata& metadata) {
  const std::string text = view::cameraText(camera);
  if (text != view::cameraText(ofFile)) metadata["candela.camera"] = text;
}

image::Image pictureOf(const image::Film& film, bool hasAlpha, Metadata metadata) {
  image::Image image = toImage(film);
  if (hasAlpha) addAlpha(image, film);
  addLayers(image, film);
  image.metadata.merge(metadata);
  return image;
}

image::Image pictureOf(const film::FilmHeader& header, const image::Film& film, Metadata metadata) {
  image::Image image = pictureOf(film, header.hasAlpha(), std::move(metadata));
  setPlace(image, header.size, header.window);
  return image;
}

void setPlace(image::Image& image, const render::Extent& frame, const render::Window& window) {
  image.origin = {window.x, window.y};
  image.frame = image::PixelBox{0, 0, frame.width, frame.height};
}

render::Integrator integratorOf(const film::FilmHeader& header) {
  return named<render::Integrator>().parse(header.setting("integrator")).value_or(render::Integrator::path);
}

void writeImages(image::Image image, const ImageFileArguments& arguments, render::Integrator integrator,
                 const Log& log) {
  const image::DisplayTransform display = chooseDisplay(arguments, integrator, image);
  if (isFalseColour(display.toneMap)) {
    image.metadata["candela.falseColour"] = falseColourText(display);
    if (std::ranges::any_of(arguments.outputs, image::isEightBit)) log.note(falseColourKey(display));
  }
  std::vector<std::string> failures;
  bool stdoutFailed = false;
  for (const auto& file : arguments.outputs) {
    try {
      writeImage(file, image, display);
    } catch (const StdoutError&) {
      stdoutFailed = true;
    } catch (const FileError& error) {
      failures.emplace_back(error.what());
    }
  }
  // Alone, it is thrown as it is: whoever closed a pipe needs no message.
  if (stdoutFailed && failures.empty()) throw StdoutError();
  if (stdoutFailed) failures.emplace_back(StdoutError().what());
  if (!failures.empty()) throw FileError(fmt::format("{}", fmt::join(failures, "\n")));
}

}  // namespace candela::cli
