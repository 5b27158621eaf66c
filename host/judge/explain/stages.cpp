// Lists the quantities of each stage.
#include "host/judge/explain/stages.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <tuple>
#include <utility>

#include "host/scene/scene.h"
#include "host/trace/render/path_trace.h"

namespace candela::explain {
namespace {

const char* kindWord(scene::PrimitiveKind kind) {
  switch (kind) {
#define CANDELA_NAME_KIND(kind, feature, name, value, flag) \
  case scene::PrimitiveKind::kind:                          \
    return #kind;
    CANDELA_PRIMITIVE_KINDS(CANDELA_NAME_KIND)
#undef CANDELA_NAME_KIND
  }
  return "";
}

const char* materialWord(const scene::Material& material) {
  switch (scene::kindOf(material)) {
    case scene::MaterialKind::black:
      return "black";
    case scene::MaterialKind::diffuse:
      return "diffuse";
    case scene::MaterialKind::glossy:
      return "glossy";
    case scene::MaterialKind::dielectric:
      return "dielectric";
    case scene::MaterialKind::mirror:
      return "mirror";
    case scene::MaterialKind::surface:
      return "surface";
    case scene::MaterialKind::choice:
      return "choice";
    case scene::MaterialKind::mixture:
      break;
  }
  return "mixture";
}

/// Returns index and kind, e.g. "7 sphere"; only the index if the scene has no such entry.
std::string primitiveWords(std::uint32_t primitive, const scene::Scene& scene) {
  if (primitive >= scene.primitives.size()) return fmt::to_string(primitive);
  return fmt::format("{} {}", primitive, kindWord(scene.primitives[primitive].kind));
}

/// Returns index and kind of a material, e.g. "2 mixture": docs/light-transport.md section 5.
std::string materialWords(std::uint32_t material, const scene::Scene& scene) {
  if (material >= scene.materials.size()) return fmt::to_string(material);
  return fmt::format("{} {}", material, materialWord(scene.materials[material]));
}

/// Returns the name of a LightTrace::primitive.
std::string lightWords(std::uint32_t primitive, const scene::Scene& scene) {
  return primitive == render::LightTrace::kPointLight ? "a light that is not a primitive"
                                                      : "primitive " + primitiveWords(primitive, scene);
}

std::string lobeWords(render::Lobe lobe) {
  switch (lobe) {
#define CANDELA_NAME_LOBE(lobe, name, value) \
  case render::Lobe::lobe:                   \
    return #lobe;
    CANDELA_LOBES(CANDELA_NAME_LOBE)
#undef CANDELA_NAME_LOBE
  }
  return "";
}

std::string shadowWords(render::ShadowOutcome outcome) {
  switch (outcome) {
    case render::ShadowOutcome::notTraced:
      break;
    case render::ShadowOutcome::visible:
      return "visible";
    case render::ShadowOutcome::occluded:
      return "occluded";
  }
  return "not traced";
}

// In the order of shaders/shared/dimensions.h.
constexpr std::array<const char*, 4> kCameraNumbers{"filter x", "filter y", "lens u", "lens v"};
constexpr std::array<const char*, 7> kVertexNumbers{"light choice", "light u", "light v",   "lobe choice",
                                                    "BSDF u",       "BSDF v",  "roulette u"};

// Returns a member of a structure that a vertex may lack.
template <class Part, class Member>
auto memberOf(const std::optional<Part>& part, Member member) {
  return part ? std::optional((*part).*member) : std::nullopt;
}

// Both sides of one vertex, or of a vertex that only one side has.
class VertexStage {
 public:
  VertexStage(const render::VertexTrace* device, const render::VertexTrace* reference, const scene::Scene& scene)
      : device_(device ? *device : render::VertexTrace{}),
        reference_(reference ? *reference : render::VertexTrace{}),
        hasDevice_(device != nullptr),
        hasReference_(reference != nullptr),
        scene_(scene) {}

  std::vector<Quantity> quantities(bool first) {
    addNumbers();
    if (!first)
      add(colour("throughput", of(&render::VertexTrace::throughput, true),
                 of(&render::VertexTrace::throughput, false)));
    addHit();
    addEmission();
    addLight();
    addScattering();
    addRoulette();
    add(colour("radiance so far", of(&render::VertexTrace::radiance, true), of(&render::VertexTrace::radiance, false)));
    return std::move(quantities_);
  }

 private:
  void add(Quantity quantity) {
    if (!quantity.device.isAbsent() || !quantity.reference.isAbsent()) quantities_.push_back(std::move(quantity));
  }

  template <class T>
  std::optional<T> of(T render::VertexTrace::*member, bool device) const {
    if (device) return hasDevice_ ? std::optional(device_.*member) : std::nullopt;
    return hasReference_ ? std::optional(reference_.*member) : std::nullopt;
  }

  // Adds a decision with `words(vertex)` of each side, empty for a side without this vertex.
  template <class Words>
  void addDecision(const char* name, Words words) {
    Quantity made = decision(name, hasDevice_ ? words(device_) : "", hasReference_ ? words(reference_) : "");
    made.differs = made.differs && hasDevice_ && hasReference_;
    add(std::move(made));
  }

  void addNumbers() {
    for (std::size_t i = 0; i < kVertexNumbers.size(); ++i) {
      const std::uint32_t word = (hasDevice_ ? device_ : reference_).numbers[i];
      add(randomNumber(kVertexNumbers[i], word, hasReference_ ? reference_.numbers[i] : word));
    }
  }

  void addHit() {
    const auto& [a, b] = std::tie(device_.hit, reference_.hit);
    addDecision("primitive", [&](const render::VertexTrace& v) {
      return v.hit ? primitiveWords(v.hit->primitive, scene_) : std::string("none: the background");
    });
    if (!a && !b) return;
    const double scale = std::max(a ? std::max(glm::length(a->position), a->distance) : 0,
                                  b ? std::max(glm::length(b->position), b->distance) : 0);
    add(vector("position", memberOf(a, &render::HitTrace::position), memberOf(b, &render::HitTrace::position), scale));
    addDecision("side", [](const render::VertexTrace& v) {
      return !v.hit ? std::string() : v.hit->fromOutside ? "outside" : "inside";
    });
    add(vector("normal", memberOf(a, &render::HitTrace::normal), memberOf(b, &render::HitTrace::normal)));
    if ((a && a->shadingNormal != a->normal) || (b && b->shadingNormal != b->normal)) {
      add(vector("shading normal", memberOf(a, &render::HitTrace::shadingNormal),
                 memberOf(b, &render::HitTrace::shadingNormal)));
    }
    addDecision("material", [&](const render::VertexTrace& v) {
      return v.hit ? materialWords(v.hit->material, scene_) : std::string();
    });
  }

  // A surface that emits on one side only is compared with zero emission.
  void addEmission() {
    const auto& [a, b] = std::tie(device_.emission, reference_.emission);
    if (!a && !b) return;
    add(scalar("emission weight", memberOf(a, &render::EmissionTrace::weight),
               memberOf(b, &render::EmissionTrace::weight)));
    const auto emitted = [](bool exists, const std::optional<render::EmissionTrace>& emission) {
      return exists ? std::optional(emission ? emission->radiance : glm::dvec3(0)) : std::nullopt;
    };
    add(colour("emission", emitted(hasDevice_, a), emitted(hasReference_, b)));
  }

  void addLight() {
    if (!device_.light && !reference_.light) return;
    addDecision("light", [](const render::VertexTrace& v) {
      return v.light ? fmt::format("entry {}", v.light->entry) : "none";
    });
    const auto position = [&](const std::optional<render::LightTrace>& light) {
      return light ? lightWords(light->primitive, scene_) : std::string();
    };
    Quantity emitter = decision("light at", position(device_.light), position(reference_.light));
    emitter.differs = emitter.differs && device_.light && reference_.light;
    add(std::move(emitter));
    addDecision("shadow ray", [](const render::VertexTrace& v) {
      return v.light ? shadowWords(v.light->shadow) : shadowWords(render::ShadowOutcome::notTraced);
    });
    const auto traced = [](const std::optional<render::LightTrace>& light) {
      return light && light->shadow != render::ShadowOutcome::notTraced ? light : std::nullopt;
    };
    addShadowRay(traced(device_.light), traced(reference_.light));
  }

  void addShadowRay(const std::optional<render::LightTrace>& a, const std::optional<render::LightTrace>& b) {
    if (!a && !b) return;
    add(vector("light direction", memberOf(a, &render::LightTrace::direction),
               memberOf(b, &render::LightTrace::direction)));
    add(scalar("light distance", memberOf(a, &render::LightTrace::distance),
               memberOf(b, &render::LightTrace::distance)));
    add(scalar("light pdf", memberOf(a, &render::LightTrace::pdf), memberOf(b, &render::LightTrace::pdf)));
    add(scalar("light BSDF pdf", memberOf(a, &render::LightTrace::bsdfPdf), memberOf(b, &render::LightTrace::bsdfPdf)));
    const auto visible = [](const std::optional<render::LightTrace>& light) {
      return light && light->shadow == render::ShadowOutcome::visible ? light : std::nullopt;
    };
    add(scalar("light weight", memberOf(visible(a), &render::LightTrace::weight),
               memberOf(visible(b), &render::LightTrace::weight)));
    add(colour("light adds", memberOf(visible(a), &render::LightTrace::radiance),
               memberOf(visible(b), &render::LightTrace::radiance)));
  }

  void addScattering() {
    const auto& [a, b] = std::tie(device_.scattering, reference_.scattering);
    if (!device_.hit && !reference_.hit) return;
    addDecision("lobe", [](const render::VertexTrace& v) {
      return v.scattering ? lobeWords(v.scattering->lobe) : std::string("none: the path ends");
    });
    add(vector("direction", memberOf(a, &render::ScatteringTrace::direction),
               memberOf(b, &render::ScatteringTrace::direction)));
    add(scalar("pdf", memberOf(a, &render::ScatteringTrace::pdf), memberOf(b, &render::ScatteringTrace::pdf)));
    add(colour("weight", memberOf(a, &render::ScatteringTrace::weight), memberOf(b, &render::ScatteringTrace::weight)));
  }

  void addRoulette() {
    const auto& [a, b] = std::tie(device_.roulette, reference_.roulette);
    if (!a && !b) return;
    add(scalar("survival", memberOf(a, &render::RouletteTrace::probability),
               memberOf(b, &render::RouletteTrace::probability)));
    addDecision("roulette", [](const render::VertexTrace& v) {
      return !v.roulette ? std::string("not played") : v.roulette->survived ? "survived" : "ended";
    });
  }

  render::VertexTrace device_;
  render::VertexTrace reference_;
  bool hasDevice_;
  bool hasReference_;
  const scene::Scene& scene_;
  std::vector<Quantity> quantities_;
};

// Returns the scale of coordinates of the scene: the distance that rays travel.
double cameraScale(const render::PathTrace& path) {
  if (path.vertices.empty()) return 0;
  const render::VertexTrace& first = path.vertices.front();
  return std::max(glm::length(first.origin), first.hit ? first.hit->distance : 0);
}

Stage cameraStage(const render::PathTrace& device, const render::PathTrace& reference) {
  Stage stage{"camera", {}};
  for (std::size_t i = 0; i < kCameraNumbers.size(); ++i) {
    stage.quantities.push_back(randomNumber(kCameraNumbers[i], device.cameraNumbers[i], reference.cameraNumbers[i]));
  }
  if (device.vertices.empty() || reference.vertices.empty()) return stage;
  const render::VertexTrace& a = device.vertices.front();
  const render::VertexTrace& b = reference.vertices.front();
  const double scale = std::max(cameraScale(device), cameraScale(reference));
  stage.quantities.push_back(vector("ray origin", a.origin, b.origin, scale));
  stage.quantities.push_back(vector("ray direction", a.direction, b.direction));
  return stage;
}

}  // namespace

std::vector<Stage> stagesOf(const render::PathTrace& device, const render::PathTrace& reference,
                            const scene::Scene& scene) {
  std::vector<Stage> stages{cameraStage(device, reference)};
  const auto at = [](const render::PathTrace& path, std::size_t i) {
    return i < path.vertices.size() ? &path.vertices[i] : nullptr;
  };
  const std::size_t count = std::max(device.vertices.size(), reference.vertices.size());
  for (std::size_t i = 0; i < count; ++i) {
    VertexStage vertex(at(device, i), at(reference, i), scene);
    stages.push_back({fmt::format("vertex {}", i + 1), vertex.quantities(i == 0)});
  }
  stages.push_back({"sample", {colour("radiance", device.radiance, reference.radiance)}});
  return stages;
}

}  // namespace candela::explain
