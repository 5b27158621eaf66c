// Traces undecidable samples again, and counts what rounding changes in them.
#include "host/judge/verify/undecided_decisions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "host/image/film.h"
#include "host/judge/verify/decisions.h"
#include "host/scene/object_names.h"

namespace candela::verify {
namespace {

constexpr std::size_t kListed = 3;  // kinds in the text
constexpr const char* kNothing = "nothing";

using render::PathTrace;
using render::VertexTrace;

// Names the surfaces of the decisions at one vertex of a path.
class VertexDecisions {
 public:
  VertexDecisions(const PathTrace& path, std::size_t vertex, const scene::Scene& scene)
      : exact_(path.vertices[vertex]), scene_(scene) {
    if (vertex > 0 && path.vertices[vertex - 1].hit) start_ = nameOf(path.vertices[vertex - 1]);
  }

  std::optional<UndecidedDecision> firstIn(const VertexTrace& replica) const {
    if (hitOf(exact_) != hitOf(replica)) {
      return primitive(nameOf(exact_), nameOf(replica));
    }
    if (!exact_.hit) return std::nullopt;
    const std::string here = nameOf(exact_);
    if (exact_.hit->fromOutside != replica.hit->fromOutside) {
      return make("side", {here}, fmt::format("{} hits {} on either side", rayText(), here));
    }
    if (entryOf(exact_) != entryOf(replica)) return make("light", {here}, "the light that is sampled at " + here);
    if (shadowOf(exact_) != shadowOf(replica)) {
      return make("shadow", {here}, fmt::format("a shadow ray from {} is occluded or not", here));
    }
    if (lobeOf(exact_) != lobeOf(replica)) return make("lobe", {here}, "the lobe that is sampled at " + here);
    if (survives(exact_) != survives(replica)) return make("roulette", {here}, "Russian roulette at " + here);
    return std::nullopt;
  }

  UndecidedDecision other() const {
    if (!exact_.hit) return make("other", {}, "the texel of the environment that " + rayText() + " hits");
    const std::string here = nameOf(exact_);
    return make("other", {here}, "a texel, an opacity, or whether light arrives at " + here);
  }

 private:
  static std::optional<std::uint32_t> hitOf(const VertexTrace& vertex) {
    return vertex.hit ? std::optional(vertex.hit->primitive) : std::nullopt;
  }
  // The entry of the chosen light, and the primitive, on which instances that emit depend, too.
  static std::optional<std::pair<std::uint32_t, std::uint32_t>> entryOf(const VertexTrace& vertex) {
    return vertex.light ? std::optional(std::pair(vertex.light->entry, vertex.light->primitive)) : std::nullopt;
  }
  static render::ShadowOutcome shadowOf(const VertexTrace& vertex) {
    return vertex.light ? vertex.light->shadow : render::ShadowOutcome::notTraced;
  }
  static render::Lobe lobeOf(const VertexTrace& vertex) {
    return vertex.scattering ? vertex.scattering->lobe : render::Lobe::none;
  }
  static bool survives(const VertexTrace& vertex) { return !vertex.roulette || vertex.roulette->survived; }

  std::string nameOf(const VertexTrace& vertex) const {
    return vertex.hit ? objectName(scene_, scene::objectOf(scene_, vertex.hit->primitive)) : kNothing;
  }
  std::string rayText() const { return start_.empty() ? "a camera ray" : "a ray from " + start_; }

  // The names are sorted, since either may be that of the exact path.
  UndecidedDecision primitive(const std::string& a, const std::string& b) const {
    if (a == b) return make("primitive", {a}, fmt::format("{} hits one primitive of {} or another", rayText(), a));
    const bool isSorted = b == kNothing || (a != kNothing && a < b);
    const std::string& first = isSorted ? a : b;
    const std::string& second = isSorted ? b : a;
    return make("primitive", {first, second}, fmt::format("{} hits {} or {}", rayText(), first, second));
  }

  UndecidedDecision make(const char* kind, const std::vector<std::string>& at, std::string text) const {
    UndecidedDecision decision{kind, {}, std::move(text), 0, 0};
    if (!start_.empty()) decision.surfaces.push_back(start_);
    for (const std::string& name : at) {
      if (name != kNothing && !std::ranges::count(decision.surfaces, name)) decision.surfaces.push_back(name);
    }
    return decision;
  }

  const VertexTrace& exact_;
  const scene::Scene& scene_;
  std::string start_;  // name of the object on which the ray starts; empty for a camera ray
};

// Every pixel that has a replica with other decisions; of many, pixels that are evenly distributed over all.
std::vector<std::size_t> chosenOf(const std::vector<render::Replica>& replicas, std::uint64_t& undecidable) {
  std::vector<std::size_t> pixels;
  for (std::size_t i = 0; i + kReplicas <= replicas.size(); i += kReplicas) {
    const auto first = replicas.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::any_of(first, first + kReplicas, [](const render::Replica& one) { return one.vertex > 0; })) {
      pixels.push_back(i / kReplicas);
    }
  }
  undecidable = pixels.size();
  if (pixels.size() <= kMaxExamined) return pixels;
  std::vector<std::size_t> chosen(kMaxExamined);
  for (std::size_t i = 0; i < chosen.size(); ++i) chosen[i] = pixels[i * pixels.size() / chosen.size()];
  return chosen;
}

void count(const UndecidedDecision& decision, double light, std::vector<UndecidedDecision>& kinds) {
  auto found = std::ranges::find_if(kinds, [&](const UndecidedDecision& one) {
    return one.kind == decision.kind && one.surfaces == decision.surfaces;
  });
  if (found == kinds.end()) found = kinds.insert(kinds.end(), decision);
  found->pixels += 1;
  found->light += light;
}

double fractionOf(const UndecidedDecision& one, std::uint64_t examined) {
  return static_cast<double>(one.pixels) / static_cast<double>(examined);
}

}  // namespace

UndecidedDecision firstUndecided(const PathTrace& exact, const PathTrace& replica, std::uint32_t vertex,
                                 const scene::Scene& scene) {
  const std::size_t common = std::min(exact.vertices.size(), replica.vertices.size());
  for (std::size_t i = 0; i < common; ++i) {
    if (const auto decision = VertexDecisions(exact, i, scene).firstIn(replica.vertices[i])) return *decision;
  }
  const std::size_t last = std::clamp<std::size_t>(vertex, 1, exact.vertices.size()) - 1;
  return VertexDecisions(exact, last, scene).other();
}

UndecidedDecisions examineUndecided(const scene::Scene& scene, std::uint32_t width, render::SampleReplayer& replayer,
                                    render::ReplicaSource& source) {
  const std::vector<render::Replica> replicas = source.replicas().replicas;
  UndecidedDecisions result;
  for (const std::size_t pixel : chosenOf(replicas, result.undecidable)) {
    const render::PixelSample sample{static_cast<std::uint32_t>(pixel % width),
                                     static_cast<std::uint32_t>(pixel / width), 0};
    const std::size_t first = kReplicas * pixel;
    const std::size_t index = replicas[first].vertex > 0 ? 0 : 1;
    const PathTrace exact = replayer.replay(sample).path;
    const std::vector<PathTrace> traces = source.replayReplicas(sample, kReplicas);
    const double light = std::abs(image::luminance(traces[index].radiance - exact.radiance));
    count(firstUndecided(exact, traces[index], replicas[first + index].vertex, scene), light, result.kinds);
    ++result.examined;
  }
  std::ranges::stable_sort(result.kinds, [](const UndecidedDecision& a, const UndecidedDecision& b) {
    return a.light != b.light ? a.light > b.light : a.pixels > b.pixels;
  });
  return result;
}

std::vector<std::string> UndecidedDecisions::lines() const {
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < std::min(kinds.size(), kListed); ++i) {
    lines.push_back(
        fmt::format("undecidable in {:.0f} % of them: {}", 100 * fractionOf(kinds[i], examined), kinds[i].text));
  }
  return lines;
}

nlohmann::ordered_json UndecidedDecisions::json() const {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const UndecidedDecision& one : kinds) {
    json.push_back({{"decision", one.kind},
                    {"surfaces", one.surfaces},
                    {"text", one.text},
                    {"pixelFraction", fractionOf(one, examined)},
                    {"light", one.light}});
  }
  return json;
}

}  // namespace candela::verify
