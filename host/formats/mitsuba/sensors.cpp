// Converts sensors, films, samplers and integrators.
#include "host/formats/mitsuba/sensors.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "host/base/lower_case.h"
#include "host/base/quote.h"
#include "host/formats/loading/framing.h"
#include "host/formats/loading/number.h"
#include "host/formats/mitsuba/names.h"
#include "host/formats/mitsuba/transform.h"
#include "host/image/image.h"

namespace candela::mitsuba {
namespace {

using scene::quote;

constexpr double kFilmDiagonalSquared = 36 * 36 + 24 * 24;  // of 35 mm film, in mm^2

/// The vertical field of view in degrees, of a picture of the given ratio of width to height.
double verticalAngle(const Object& sensor, double aspect) {
  double fov = 0;
  std::string axis = "x";
  if (sensor.has("fov")) {
    if (sensor.has("focal_length")) throw PlacedError{sensor.place, "a sensor has either \"fov\" or \"focal_length\""};
    fov = sensor.number("fov", 0);
    axis = lowerCase(sensor.text("fov_axis", "x"));
    if (axis == "smaller") axis = aspect > 1 ? "y" : "x";
    if (axis == "larger") axis = aspect > 1 ? "x" : "y";
  } else {
    std::string text = sensor.text("focal_length", "50mm");
    if (text.ends_with("mm")) text.resize(text.size() - 2);
    const auto length = scene::parseDouble(text);
    if (length.status != scene::NumberStatus::ok || !(length.value > 0)) {
      throw PlacedError{sensor.place, "the focal length is a positive number of millimetres, such as \"50mm\""};
    }
    static_cast<void>(sensor.has("fov_axis"));  // of no meaning here
    fov = glm::degrees(2 * std::atan(std::sqrt(kFilmDiagonalSquared) / (2 * length.value)));
    axis = "diagonal";
  }
  if (!(fov > 0 && fov < 180)) throw PlacedError{sensor.place, "the field of view is between 0 and 180 degrees"};
  if (axis == "y") return fov;
  const double tangent = std::tan(glm::radians(fov) / 2);
  if (axis == "x") return glm::degrees(2 * std::atan(tangent / aspect));
  if (axis == "diagonal") return glm::degrees(2 * std::atan(tangent / std::sqrt(1 + aspect * aspect)));
  throw PlacedError{sensor.place,
                    fmt::format("{} is none of the axes x, y, diagonal, smaller and larger", quote(axis))};
}

/// The frame of a sensor, whose pictures have the x axis at the left, the y axis at the top and look along z.
struct Frame {
  glm::dvec3 origin, left, up, forward;
};

Frame frameOf(const Object& sensor) {
  const glm::dmat4 map = sensor.transform("to_world");
  const Frame frame{placed(map, glm::dvec3(0)), turned(map, {1, 0, 0}), turned(map, {0, 1, 0}), turned(map, {0, 0, 1})};
  constexpr double kTolerance = 1e-3;
  const auto cosine = [](const glm::dvec3& a, const glm::dvec3& b) {
    return std::abs(glm::dot(a, b)) / (glm::length(a) * glm::length(b));
  };
  const bool isStraight = cosine(frame.left, frame.up) <= kTolerance && cosine(frame.up, frame.forward) <= kTolerance &&
                          cosine(frame.forward, frame.left) <= kTolerance;
  if (!isStraight) throw PlacedError{sensor.place, "the transform of the sensor shears or has a scale of 0"};
  return frame;
}

double depthOf(const std::optional<scene::Bounds>& bounds, const Frame& frame) {
  if (!bounds) return 1;
  const double depth = glm::dot(scene::centreOf(*bounds) - frame.origin, glm::normalize(frame.forward));
  return depth > 0 ? depth : 1;
}

/// The axis of the scene that is nearest to a direction.
glm::vec3 nearestAxis(const glm::dvec3& direction) {
  int axis = 0;
  for (int i = 1; i < 3; ++i) {
    if (std::abs(direction[i]) > std::abs(direction[axis])) axis = i;
  }
  glm::vec3 result(0);
  result[axis] = direction[axis] < 0 ? -1.0f : 1.0f;
  return result;
}

void setFilter(const Object& film, Report& report, scene::Scene& scene) {
  const Object* const filter = film.onlyNested("rfilter");
  const std::string type = filter ? filter->type : "gaussian";
  constexpr std::array<std::string_view, 6> kFilters{"box", "tent", "gaussian", "mitchell", "catmullrom", "lanczos"};
  if (filter && std::ranges::count(kFilters, type) == 0)
    throw PlacedError{filter->place, fmt::format("unknown filter {}", quote(type))};
  const double radius = filter && type != "gaussian" ? filter->number("radius", type == "box" ? 0.5 : 1) : 0;
  const bool isBox = type == "box" && radius == 0.5, isTent = type == "tent" && radius == 1;
  if (isBox) scene.requestedFilter = scene::PixelFilter{scene::FilterKind::box};
  if (isTent) scene.requestedFilter = scene::PixelFilter{scene::FilterKind::tent};
  if (type == "gaussian") {
    const double deviation = filter ? filter->number("stddev", 0.5) : 0.5;
    if (!(deviation >= scene::kMinDeviation && deviation <= scene::kMaxDeviation)) {
      throw PlacedError{filter->place, fmt::format("the stddev of a gaussian filter is from {} to {}",
                                                   scene::kMinDeviation, scene::kMaxDeviation)};
    }
    scene.requestedFilter = scene::PixelFilter{scene::FilterKind::gaussian, static_cast<float>(deviation)};
  } else if (!isBox && !isTent) {
    report.omit(fmt::format("the filter {}{}, instead of which the picture has that of --filter", quote(type),
                            type == "box" || type == "tent" ? " of this radius" : ""));
  }
  if (!filter) return;
  filter->ignore({"stddev", "lobes", "B", "C", "a", "b"}, report);
  filter->reportUnused(report);
}

std::uint32_t sideOf(const Object& film, const char* name, std::int64_t absent) {
  const std::int64_t side = film.integer(name, absent);
  if (side < 1 || side > image::kMaxImageSide) {
    throw PlacedError{film.place, fmt::format("the {} of the film is from 1 to {}", name, image::kMaxImageSide)};
  }
  return static_cast<std::uint32_t>(side);
}

// The defaults are those of Mitsuba: the offset is 0, and the size is that of the film.
void setCrop(const Object& film, const scene::Camera& camera, scene::Scene& scene) {
  const std::int64_t x = film.integer("crop_offset_x", 0), y = film.integer("crop_offset_y", 0);
  const std::int64_t width = film.integer("crop_width", camera.width);
  const std::int64_t height = film.integer("crop_height", camera.height);
  if (x < 0 || y < 0 || width < 1 || height < 1 || width > camera.width - x || height > camera.height - y) {
    throw PlacedError{film.place, fmt::format("the window {},{},{},{} (crop_offset_x, ...) is not within the film of "
                                              "{} by {} pixels",
                                              x, y, width, height, camera.width, camera.height)};
  }
  const scene::Extent size{camera.width, camera.height};
  const scene::Window window{static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y),
                             static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)};
  if (window != windowOf(size)) scene.requestedCrop = window;
}

void setFilm(const Object* film, Report& report, scene::Camera& camera, scene::Scene& scene) {
  camera.width = 768;
  camera.height = 576;
  if (!film) {
    report.omit("the filter \"gaussian\", instead of which the picture has that of --filter");
    return;
  }
  constexpr std::array<std::string_view, 5> kFilms{"hdrfilm", "ldrfilm", "tiledhdrfilm", "mfilm", "specfilm"};
  if (std::ranges::count(kFilms, film->type) == 0)
    throw PlacedError{film->place, fmt::format("unknown film {}", quote(film->type))};
  if (film->type == "specfilm") report.deviate(film->place, "a film of spectra is not rendered", "renders colours");
  camera.width = sideOf(*film, "width", camera.width);
  camera.height = sideOf(*film, "height", camera.height);
  setCrop(*film, camera, scene);
  setFilter(*film, report, scene);
  film->ignore({"file_format", "pixel_format", "component_format", "compensate", "sample_border", "high_quality_edges",
                "banner", "attach_log", "gamma", "exposure", "key", "burn", "tonemap_method", "variable", "digits"},
               report);
  if (film->type == "specfilm") film->useAll();
  film->reportUnused(report);
}

void setSampler(const Object* sampler, Report& report, scene::Scene& scene) {
  if (!sampler) return;
  const std::int64_t count = sampler->integer("sample_count", 4);
  if (count < 1 || count > (std::int64_t{1} << 30))
    throw PlacedError{sampler->place, "the number of samples is from 1 to 2^30"};
  scene.requestedSamples = static_cast<std::uint32_t>(count);
  sampler->ignore({"seed", "jitter", "dimension", "scramble"}, report);
  sampler->reportUnused(report);
}

void setLens(const Object& sensor, const Frame& frame, const std::optional<scene::Bounds>& bounds,
             scene::Camera& camera) {
  camera.angle = static_cast<float>(verticalAngle(sensor, static_cast<double>(camera.width) / camera.height));
  double depth = depthOf(bounds, frame);
  if (sensor.type == "thinlens") {
    const double radius = sensor.number("aperture_radius", 0);
    if (!sensor.has("aperture_radius") || !(radius >= 0))
      throw PlacedError{sensor.place, "a sensor \"thinlens\" has an \"aperture_radius\" of at least 0"};
    depth = sensor.number("focus_distance", sensor.number("far_clip", 1e4));
    if (!(depth > 0)) throw PlacedError{sensor.place, "the focus distance is positive"};
    const double height = 2 * depth * std::tan(glm::radians(double{camera.angle}) / 2);
    camera.aperture = static_cast<float>(radius / height * camera.height);
  }
  camera.at = glm::vec3(frame.origin + depth * glm::normalize(frame.forward));
}

void setOrthographic(const Object& sensor, const Frame& frame, const std::optional<scene::Bounds>& bounds,
                     scene::Camera& camera) {
  const double width = glm::length(frame.left), height = glm::length(frame.up);
  if (std::abs(width - height) > 1e-3 * width)
    throw PlacedError{sensor.place, "the transform of the sensor scales x and y differently"};
  camera.orthographicHeight = static_cast<float>(2 * width * camera.height / camera.width);
  camera.at = glm::vec3(frame.origin + depthOf(bounds, frame) * glm::normalize(frame.forward));
}

}  // namespace

const Object* chooseSensor(const std::vector<const Object*>& sensors, const scene::LoadOptions& options,
                           const std::string& file) {
  if (!options.camera) return sensors.empty() ? nullptr : sensors.front();
  if (*options.camera == "none") return nullptr;
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    if (sensors[i]->id == *options.camera || std::to_string(i) == *options.camera) return sensors[i];
  }
  std::vector<std::string_view> ids;
  for (const Object* const sensor : sensors) ids.push_back(sensor->id);
  throw scene::SceneError({{file, 0, 0,
                            fmt::format("no sensor has the id or the index {}{}", quote(*options.camera),
                                        suggestionFor(*options.camera, ids))}});
}

void setSensor(const Object& sensor, const std::optional<scene::Bounds>& bounds, Report& report, scene::Scene& scene) {
  constexpr std::array<std::string_view, 3> kRendered{"perspective", "thinlens", "orthographic"};
  if (std::ranges::count(kRendered, sensor.type) == 0) {
    report.deviate(sensor.place, fmt::format("{} is not rendered", sensor.description()),
                   "renders a view that frames the scene");
    sensor.useAll();
    return;
  }
  scene::Camera camera;
  setFilm(sensor.onlyNested("film"), report, camera, scene);
  setSampler(sensor.onlyNested("sampler"), report, scene);
  const Frame frame = frameOf(sensor);
  camera.isMirrored = glm::dot(glm::cross(frame.left, frame.up), frame.forward) < 0;
  camera.from = glm::vec3(frame.origin);
  camera.up = glm::vec3(glm::normalize(frame.up));
  if (sensor.type == "orthographic") {
    setOrthographic(sensor, frame, bounds, camera);
  } else {
    setLens(sensor, frame, bounds, camera);
  }
  if (!(camera.angle > 0 && camera.angle < 180) || camera.at == camera.from) {
    throw PlacedError{sensor.place, "single precision cannot represent the view"};
  }
  if (sensor.type == "perspective") {
    camera.shift = glm::vec2(sensor.number("principal_point_offset_x", 0),
                             sensor.number("principal_point_offset_y", 0));
  }
  sensor.ignore({"near_clip", "far_clip", "focus_distance", "shutter_open", "shutter_close"}, report);
  sensor.reportUnused(report);
  scene.camera = camera;
  scene.up = nearestAxis(frame.up);
}

std::string setIntegrator(const Object& integrator, Report& report, scene::Scene& scene) {
  constexpr std::array<std::string_view, 2> kNestingIntegrators{"moment", "aov"};
  constexpr std::array<std::string_view, 4> kPaths{"path", "volpath", "volpathmis", "ptracer"};
  constexpr std::array<std::string_view, 8> kOtherIntegrators{"depth",        "stokes", "prb",  "bdpt",
                                                              "photonmapper", "ppm",    "sppm", "mlt"};
  if (std::ranges::count(kNestingIntegrators, integrator.type) > 0) {
    const Object* const nested = integrator.onlyNested("integrator");
    integrator.ignore({"aovs"}, report);
    integrator.reportUnused(report);
    if (!nested)
      throw PlacedError{integrator.place, fmt::format("{} has no nested integrator", integrator.description())};
    if (std::ranges::count(kNestingIntegrators, nested->type) > 0)
      throw PlacedError{nested->place, "the integrator is nested twice"};
    return setIntegrator(*nested, report, scene);
  }
  const bool isPath = std::ranges::count(kPaths, integrator.type) > 0, isDirect = integrator.type == "direct";
  if (!isPath && !isDirect) {
    if (std::ranges::count(kOtherIntegrators, integrator.type) == 0) {
      throw PlacedError{integrator.place, fmt::format("unknown integrator {}", quote(integrator.type))};
    }
    report.deviate(integrator.place, fmt::format("{} is not rendered", integrator.description()), "traces paths");
    integrator.useAll();
    return "path";
  }
  integrator.ignore({"rr_depth", "emitter_samples", "bsdf_samples", "shading_samples", "strict_normals",
                     "samples_per_pass", "block_size", "timeout", "use_mis"},
                    report);
  if (integrator.flag("hide_emitters", false)) {
    report.omit("hide_emitters of the integrator, instead of which --background none hides an environment");
  }
  const std::int64_t depth = integrator.integer("max_depth", -1);
  integrator.reportUnused(report);
  if (isPath && (depth < -1 || depth == 0)) {
    throw PlacedError{integrator.place, "\"max_depth\" is -1, or at least 1; a picture of depth 0 is black"};
  }
  constexpr std::int64_t kUnlimited = 1024, kDirect = 2, kLargest = 1 << 20;
  const std::int64_t rays = isDirect ? kDirect : depth == -1 ? kUnlimited : std::min(depth, kLargest);
  scene.requestedMaxDepth = static_cast<std::uint32_t>(rays);
  return isDirect ? "direct" : depth == -1 ? "path" : fmt::format("path, max_depth {}", depth);
}

}  // namespace candela::mitsuba
