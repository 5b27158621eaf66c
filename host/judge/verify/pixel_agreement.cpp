// Compares images of one sample per pixel with their path records.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host/judge/verify/agreement.h"

namespace candela::verify {
namespace {

bool equalChannels(const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 tolerance = glm::max(kRelativeTolerance * glm::max(glm::abs(a), glm::abs(b)), kAbsoluteTolerance);
  return glm::all(glm::lessThanEqual(glm::abs(a - b), tolerance));
}

double meanLuminance(const image::Film& film) {
  double sum = 0;
  for (std::uint32_t y = 0; y < film.height(); ++y) {
    for (std::uint32_t x = 0; x < film.width(); ++x) sum += image::luminance(film.mean(x, y));
  }
  return sum / (static_cast<double>(film.width()) * film.height());
}

void noteDifference(PixelAgreement& result, double difference, std::uint32_t x, std::uint32_t y) {
  if (difference <= result.worst) return;
  result.worst = difference;
  result.worstX = x;
  result.worstY = y;
}

}  // namespace

Cause causeOf(const render::PathRecord& device, const render::PathRecord& reference) {
  const std::uint32_t count = std::max(device.vertexCount, reference.vertexCount);
  for (std::uint32_t i = 0; i < count; ++i) {
    const render::VertexRecord& a = device.vertices[i];
    const render::VertexRecord& b = reference.vertices[i];
    if (i >= device.vertexCount || i >= reference.vertexCount) return Cause::roulette;
    if (a.primitive != b.primitive) return Cause::primitive;
    if (a.shadow != b.shadow || a.visibleLights != b.visibleLights) return Cause::shadow;
    if (a.lobe != b.lobe) return Cause::lobe;
    if (a.survivedRoulette != b.survivedRoulette) return Cause::roulette;
  }
  return Cause::rounding;
}

PixelAgreement comparePixels(const render::RenderResult& device, const render::RenderResult& reference) {
  PixelAgreement result;
  for (std::uint32_t y = 0; y < device.film.height(); ++y) {
    for (std::uint32_t x = 0; x < device.film.width(); ++x) {
      const glm::dvec3 a = device.film.mean(x, y);
      const glm::dvec3 b = reference.film.mean(x, y);
      const bool lit = a != glm::dvec3(0) || b != glm::dvec3(0);
      const bool equal = equalChannels(a, b);
      result.pixels += 1;
      result.equal += equal;
      result.lit += lit;
      result.litEqual += lit && equal;
      if (equal) continue;
      const std::size_t pixel = std::size_t{y} * device.film.width() + x;
      result.causes[static_cast<std::size_t>(causeOf(device.paths[pixel], reference.paths[pixel]))] += 1;
      const glm::dvec3 difference = glm::abs(a - b);
      noteDifference(result, std::max({difference.x, difference.y, difference.z}), x, y);
    }
  }
  return result;
}

std::optional<PixelAgreement> comparePaths(const scene::Scene& scene, const render::RenderSettings& settings,
                                           render::Renderer& device, render::Renderer& reference, double level,
                                           const render::RenderControl& control, PathRenders& renders) {
  render::RenderSettings single = settings;
  single.image.sampleCount = 1;
  single.execution.recordPaths = true;
  const render::RenderResult a = device.render(scene, single, control);
  single.execution.replicas = kReplicas;
  const std::unique_ptr<render::Session> session = reference.prepare(scene, single);
  render::RenderResult b;
  b.interrupted = !session->advance({0, 1}, control);
  b.film = session->film();
  b.paths = session->recorder()->paths();
  renders.deviceStatistics = a.statistics;
  renders.badSamples.device.add(a.film, single.image);
  renders.badSamples.reference.add(b.film, single.image);
  if (a.interrupted || b.interrupted) return std::nullopt;
  PixelAgreement result = comparePixels(a, b);
  render::ReplicaSource* const replicas = session->replicaSource();
  if (replicas != nullptr) result.decisions = testDecisions(a.film, *replicas, level);
  render::SampleReplayer* const replayer = session->replayer();
  if (result.decisions.isPossible && replayer != nullptr) {
    result.undecided = examineUndecided(scene, a.film.width(), *replayer, *replicas);
  }
  result.referenceMean = meanLuminance(b.film);
  return result;
}

std::string PixelAgreement::causesText() const {
  std::string text;
  for (std::size_t i = 0; i < causes.size(); ++i) text += fmt::format(" {} {}", kCauseNames[i], causes[i]);
  if (worst > 0) text += fmt::format("; largest {:.6g} at {},{}", worst, worstX, worstY);
  return text;
}

nlohmann::ordered_json PixelAgreement::json() const {
  nlohmann::ordered_json json{{"agrees", agree()},
                              {"count", pixels},
                              {"equal", equal},
                              {"equalFraction", equalFraction()},
                              {"lit", lit},
                              {"litEqual", litEqual},
                              {"litEqualFraction", litEqualFraction()}};
  for (std::size_t i = 0; i < causes.size(); ++i) json["causes"][kCauseNames[i]] = causes[i];
  json["worst"] = {{"difference", worst}, {"x", worstX}, {"y", worstY}};
  json["decisions"] = decisions.json();
  json["undecidedDecisions"] = undecided.json();
  return json;
}

}  // namespace candela::verify
