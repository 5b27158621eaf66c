// Maps the parameters of BSDFs to lobes and to parameters of surfaces.
#include "host/formats/mitsuba/bsdfs.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "host/base/lower_case.h"
#include "host/base/quote.h"
#include "host/formats/mitsuba/materials.h"
#include "host/formats/mitsuba/names.h"

namespace candela::mitsuba {
namespace {

using scene::quote;
using scene::TextureSlot;

constexpr int kMaxNesting = 16;     // of nested BSDFs
constexpr double kMinAlpha = 1e-4;  // of microfacets
constexpr double kMinPrincipledAlpha = 1e-3;
constexpr double kMinRoughIor = 1.01;  // of a rough dielectric, or its inverse: section 5.15 of light-transport.md

/// BSDFs of Mitsuba that are not rendered, and have no nested one.
constexpr std::array<std::string_view, 15> kOtherBsdfs{"hair",      "measured",       "measured_polarized",
                                                       "polarizer", "retarder",       "circular",
                                                       "pplastic",  "principledthin", "phong",
                                                       "ward",      "irawan",         "difftrans",
                                                       "hk",        "mixturebsdf",    "roughcoating"};
constexpr std::array<std::string_view, 15> kRenderedBsdfs{
    "diffuse",        "dielectric", "thindielectric", "roughdielectric", "conductor",
    "roughconductor", "plastic",    "roughplastic",   "principled",      "twosided",
    "mask",           "normalmap",  "bumpmap",        "blendbsdf",       "null"};

void set(scene::Material& material, TextureSlot slot, const std::optional<scene::TextureReference>& texture) {
  material.textures[static_cast<std::size_t>(slot)] = texture;
}

glm::vec3 limited(const glm::dvec3& colour) { return glm::vec3(glm::clamp(colour, 0.0, 1.0)); }

/// The index of refraction of the inside relative to the outside; `absent`: the material of the inside by default.
double relativeIor(const Object& bsdf, const char* absent) {
  return iorOf(bsdf, "int_ior", absent) / iorOf(bsdf, "ext_ior", "air");
}

/// Candela's perceptual roughness, of which Mitsuba's alpha is the square.
float roughnessOf(double alpha) { return static_cast<float>(std::sqrt(std::clamp(alpha, 0.0, 1.0))); }

/// Microfacets of alpha u along the tangent and of v across it, as parameters of a surface: along the direction in
/// which it is rougher, alpha is mix(b, 1, s^2) with the alpha b across it.
struct Microfacets {
  float roughness = 0;
  float anisotropy = 0;  ///< s
  bool areRougherAlongV = false;
};

Microfacets microfacetsOf(double u, double v) {
  const double rough = std::clamp(std::max(u, v), kMinAlpha, 1.0), smooth = std::clamp(std::min(u, v), kMinAlpha, 1.0);
  const double strength = smooth < 1 ? std::sqrt(std::max((rough - smooth) / (1 - smooth), 0.0)) : 0;
  return {roughnessOf(smooth), static_cast<float>(strength), v > u};
}

/// The coordinates of texture reference run along those of the mesh, so that both have the same tangents.
bool isUpright(const scene::TextureReference& use) {
  return use.rowS.x != 0 && use.rowS.y == 0 && use.rowT.x == 0 && use.rowT.y != 0;
}

/// Only surfaces with parameters have normal maps. That of a lobe scatters as the lobe does.
void makeSurface(scene::Material& material) {
  if (material.surface) return;
  scene::SurfaceParameters surface;
  surface.roughness = 0;
  if (material.diffuse) {
    surface.baseColour = material.diffuse->colour;
    surface.specularWeight = 0;
    surface.ior = 0;
  } else if (material.mirror) {
    surface.baseColour = material.mirror->colour;
    surface.metalness = 1;
    surface.bareInterface = scene::Interface::smooth;
  }
  material.surface = surface;
  material.diffuse.reset();
  material.mirror.reset();
}

}  // namespace

const Bsdf& Bsdfs::read(const Object& bsdf) {
  const auto known = known_.find(&bsdf);
  if (known != known_.end()) return known->second;
  return known_[&bsdf] = make(bsdf, 1);
}

Bsdf Bsdfs::make(const Object& bsdf, int depth) {
  if (depth > kMaxNesting)
    throw PlacedError{bsdf.place, fmt::format("BSDFs are nested more than {} deep", kMaxNesting)};
  const std::string& type = bsdf.type;
  const auto dispatch = [&]() -> Bsdf {
    if (type == "diffuse") return diffuse(bsdf);
    if (type == "dielectric" || type == "thindielectric")
      return dielectric(bsdf, relativeIor(bsdf, "bk7"), scene::Interface::smooth);
    if (type == "roughdielectric") return roughDielectric(bsdf, relativeIor(bsdf, "bk7"));
    if (type == "conductor" || type == "roughconductor") return conductor(bsdf, type == "roughconductor");
    if (type == "plastic" || type == "roughplastic") return plastic(bsdf, type == "roughplastic");
    if (type == "principled") return principled(bsdf);
    if (type == "twosided") return twoSided(bsdf, depth);
    if (type == "blendbsdf") return blend(bsdf, depth);
    if (type == "mask") return mask(bsdf, depth);
    if (type == "normalmap") return normalMap(bsdf, depth);
    if (type == "bumpmap") return bumpMap(bsdf, depth);
    if (type == "null") return {.isInvisible = true, .isTwoSided = true};
    if (type == "coating") return replaced(bsdf, "renders its nested BSDF", depth);
    if (std::ranges::count(kOtherBsdfs, type) > 0) return replaced(bsdf, "renders grey instead", depth);
    throw PlacedError{bsdf.place, fmt::format("unknown BSDF {}{}", quote(type), suggestionFor(type, kRenderedBsdfs))};
  };
  Bsdf result = dispatch();
  forEachLeaf(result, [](Bsdf& leaf) { leaf.material.opaque = !leaf.isTwoSided; });
  bsdf.reportUnused(report_);
  return result;
}

Texture Bsdfs::baseColour(const Object& bsdf, const char* name, double absent, Bsdf& result) {
  Texture colour = textures_.read(bsdf, name, absent, ColourUse::reflectance, Encoding::srgb);
  set(result.material, TextureSlot::baseColour, colour.reference);
  result.attribute = colour.attribute;
  return colour;
}

glm::dvec3 Bsdfs::constant(const Object& bsdf, const char* name, double absent, ColourUse use) {
  const Texture texture = textures_.read(bsdf, name, absent, use, Encoding::srgb);
  if (texture.reference || texture.attribute) {
    report_.deviate(bsdf.find(name)->place,
                    fmt::format("a texture of {} of {} is not rendered", quote(name), bsdf.description()),
                    "renders its brightest value");
  }
  return texture.factor;
}

Bsdf Bsdfs::diffuse(const Object& bsdf) {
  Bsdf result;
  const Texture colour = baseColour(bsdf, "reflectance", 0.5, result);
  result.material.diffuse = scene::DiffuseLobe{.colour = limited(colour.factor)};
  return result;
}

Bsdf Bsdfs::dielectric(const Object& bsdf, double ior, scene::Interface shape) {
  Bsdf result{.isTwoSided = true};
  const Texture reflected = textures_.read(bsdf, "specular_reflectance", 1, ColourUse::reflectance, Encoding::srgb);
  if (reflected.attribute) {
    report_.deviate(bsdf.find("specular_reflectance")->place,
                    fmt::format("vertex colours of the reflection of {} are not rendered", bsdf.description()),
                    "leaves them out");
  }
  set(result.material, TextureSlot::specularColour, reflected.reference);
  const Texture transmitted = baseColour(bsdf, "specular_transmittance", 1, result);
  result.material.surface = scene::SurfaceParameters{.baseColour = limited(transmitted.factor),
                                                     .specularColour = limited(reflected.factor),
                                                     .roughness = 0,
                                                     .ior = static_cast<float>(ior),
                                                     .transmissionWeight = 1,
                                                     .isThinWalled = bsdf.type == "thindielectric",
                                                     .bareInterface = shape};
  return result;
}

scene::Interface Bsdfs::distribution(const Object& bsdf) {
  bsdf.ignore({"sample_visible"}, report_);
  const std::string name = lowerCase(bsdf.text("distribution", "beckmann"));
  if (name == "ggx") return scene::Interface::ggx;
  if (name == "beckmann") return scene::Interface::beckmann;
  if (name != "phong" && name != "as") {
    throw PlacedError{bsdf.place, fmt::format("{} is no distribution of microfacets", quote(name))};
  }
  report_.deviate(bsdf.place, fmt::format("{}: the distribution {} is not rendered", bsdf.description(), quote(name)),
                  "renders \"ggx\" with the same alpha");
  return scene::Interface::ggx;
}

void Bsdfs::setRoughness(const Object& bsdf, scene::Material& material) {
  scene::SurfaceParameters& surface = *material.surface;
  surface.roughness = 1;
  if (!bsdf.has("alpha_u") && !bsdf.has("alpha_v")) {
    const Texture alpha = textures_.read(bsdf, "alpha", 0.1, ColourUse::unbounded, Encoding::roughness);
    set(material, TextureSlot::metallicRoughness, alpha.reference);
    if (!alpha.reference) surface.roughness = roughnessOf(alpha.factor.x);
    return;
  }
  std::array<Numbers, 2> alphas{textures_.readNumbers(bsdf, "alpha_u", 0.1),
                                textures_.readNumbers(bsdf, "alpha_v", 0.1)};
  putOnOneGrid(bsdf, alphas);
  const Numbers &u = alphas[0], &v = alphas[1];
  setMicrofacets(
      bsdf, u, u.name + ' ' + v.name, [&](std::size_t i) { return glm::dvec3(u.at(i), v.at(i), 1); }, material);
}

void Bsdfs::putOnOneGrid(const Object& bsdf, std::span<Numbers> numbers) {
  if (mitsuba::putOnOneGrid(numbers)) return;
  report_.deviate(bsdf.place,
                  fmt::format("textures of the roughness or the metalness of {} that have different transforms, wrap "
                              "modes or filters are not rendered",
                              bsdf.description()),
                  "takes the largest number of all but the first");
}

// Numbers of textures are in two images, because the roughness and the anisotropy of a surface have each their own.
void Bsdfs::setMicrofacets(const Object& bsdf, const Numbers& grid, const std::string& name,
                           const std::function<glm::dvec3(std::size_t)>& texelAt, scene::Material& material) {
  scene::SurfaceParameters& surface = *material.surface;
  if (!grid.use) {
    const glm::dvec3 texel = texelAt(0);
    const Microfacets facets = microfacetsOf(texel.x, texel.y);
    surface.roughness = facets.roughness;
    surface.anisotropy = facets.anisotropy;
    if (facets.areRougherAlongV) surface.anisotropyRotation = static_cast<float>(std::numbers::pi / 2);
    return;
  }
  surface.roughness = 1;
  scene::TextureImage roughness{"roughness", grid.width, grid.height, {}};
  scene::TextureImage anisotropy{"anisotropy", grid.width, grid.height, {}};
  bool isAnisotropic = false;
  for (std::size_t i = 0; i < std::size_t{grid.width} * grid.height; ++i) {
    const glm::dvec3 texel = texelAt(i);
    const Microfacets facets = microfacetsOf(texel.x, texel.y);
    roughness.deepTexels.push_back(deepTexelOf({1, facets.roughness, texel.z}));
    const glm::dvec2 direction = facets.areRougherAlongV ? glm::dvec2(0, 1) : glm::dvec2(1, 0);
    anisotropy.deepTexels.push_back(deepTexelOf({(direction + 1.0) / 2.0, facets.anisotropy}));
    isAnisotropic = isAnisotropic || facets.anisotropy > 0;
  }
  if (isAnisotropic && !isUpright(*grid.use)) {
    report_.deviate(bsdf.place,
                    fmt::format("textures of the roughness of {} that \"to_uv\" turns are rendered without anisotropy",
                                bsdf.description()),
                    "takes the smaller alpha in both directions");
    isAnisotropic = false;
  }
  const auto setTexture = [&](TextureSlot slot, scene::TextureImage image) {
    scene::TextureReference use = *grid.use;
    const std::string key = fmt::format("{} of {} {} by {} {} {} {}", image.name, name, grid.width, grid.height,
                                        static_cast<int>(use.filter), static_cast<int>(use.wrapS),
                                        static_cast<int>(use.wrapT));
    use.image = textures_.storeMade(key, std::move(image));
    set(material, slot, use);
  };
  setTexture(TextureSlot::metallicRoughness, std::move(roughness));
  if (!isAnisotropic) return;
  setTexture(TextureSlot::anisotropy, std::move(anisotropy));
  surface.anisotropy = 1;
}

Bsdf Bsdfs::roughDielectric(const Object& bsdf, double ior) {
  const bool isNearOne = std::max(ior, 1 / ior) < kMinRoughIor;
  if (isNearOne) {
    report_.deviate(bsdf.place,
                    fmt::format("a rough dielectric whose indices of refraction differ by a factor of less than {} "
                                "is not rendered",
                                kMinRoughIor),
                    "renders that factor");
  }
  const double rendered = isNearOne ? (ior < 1 ? 1 / kMinRoughIor : kMinRoughIor) : ior;
  Bsdf result = dielectric(bsdf, rendered, distribution(bsdf));
  setRoughness(bsdf, result.material);
  return result;
}

Bsdf Bsdfs::conductor(const Object& bsdf, bool isRough) {
  Bsdf result;
  std::optional<scene::Conductor> index;
  const Property* const material = bsdf.find("material");
  const bool isStated = bsdf.has("eta") || bsdf.has("k");
  const std::string name = bsdf.text("material", isOld_ && !isStated ? "Cu" : "none");
  if (material && name != "none" && isStated) {
    throw PlacedError{material->place, "a conductor has either \"material\", or \"eta\" and \"k\""};
  }
  if (name != "none") {
    index = metalOf(material ? *material : Property{"material", name, bsdf.place}, name);
  } else if (isStated) {
    const double outside = isOld_ ? iorOf(bsdf, "ext_eta", "air") : 1;
    index = scene::Conductor{glm::max(glm::vec3(constant(bsdf, "eta", 0, ColourUse::unbounded) / outside), kMinIor),
                             glm::vec3(constant(bsdf, "k", 1, ColourUse::unbounded) / outside)};
  }
  const Texture colour = baseColour(bsdf, "specular_reflectance", 1, result);
  const scene::Interface shape = isRough ? distribution(bsdf) : scene::Interface::smooth;
  if (!index && !isRough) {
    result.material.mirror = scene::MirrorLobe{limited(colour.factor)};
    return result;
  }
  scene::SurfaceParameters surface;
  surface.baseColour = limited(colour.factor);
  surface.metalness = 1;
  surface.roughness = 0;
  surface.conductor = index;
  surface.bareInterface = shape;
  result.material.surface = surface;
  if (isRough) setRoughness(bsdf, result.material);
  return result;
}

// The tables of a rough boundary take up to 0.1 s.
const scene::Plastic& Bsdfs::plasticOf(const Object& bsdf, scene::Interface boundary, float roughness, float ior,
                                       bool isNonlinear) {
  const auto [entry, isNew] = plastics_.try_emplace({boundary, roughness, ior, isNonlinear});
  if (plastics_.size() > kMaxPlastics) {
    throw PlacedError{bsdf.place, fmt::format("a scene has at most {} kinds of plastic", kMaxPlastics)};
  }
  if (isNew) entry->second = scene::makePlastic(boundary, roughness, ior, isNonlinear);
  return entry->second;
}

Bsdf Bsdfs::plastic(const Object& bsdf, bool isRough) {
  Bsdf result;
  const Texture colour = baseColour(bsdf, "diffuse_reflectance", 0.5, result);
  const double ior = relativeIor(bsdf, "polypropylene");
  if (ior <= 1) {
    report_.deviate(bsdf.place, "plastic whose index of refraction is at most that of its outside is not rendered",
                    "renders it with 1.0001 times that");
  }
  auto boundary = scene::Interface::smooth;
  double alpha = 0;
  if (isRough) {
    boundary = distribution(bsdf);
    alpha = constant(bsdf, "alpha", 0.1, ColourUse::unbounded).x;
  }
  scene::SurfaceParameters surface;
  surface.baseColour = limited(colour.factor);
  surface.roughness = roughnessOf(alpha);
  surface.ior = static_cast<float>(std::max(ior, 1.0001));
  surface.specularColour = glm::vec3(constant(bsdf, "specular_reflectance", 1, ColourUse::reflectance));
  surface.plastic = plasticOf(bsdf, boundary, surface.roughness, surface.ior, bsdf.flag("nonlinear", false));
  result.material.surface = surface;
  return result;
}

// The specular reflectance at normal incidence is 0.08 times "specular".
Bsdf Bsdfs::principled(const Object& bsdf) {
  Bsdf result;
  report_.omit(
      "what distinguishes bsdf \"principled\" from glTF's metallic-roughness, of which it has base_color, roughness, "
      "anisotropic, metallic, eta or specular, and spec_trans");
  bsdf.omit({"sheen", "sheen_tint", "flatness", "spec_tint", "clearcoat", "clearcoat_gloss"}, report_);
  bsdf.ignore({"main_specular_sampling_rate", "clearcoat_sampling_rate", "diffuse_reflectance_sampling_rate"}, report_);
  const Texture colour = baseColour(bsdf, "base_color", 0.5, result);
  scene::SurfaceParameters surface;
  surface.baseColour = limited(colour.factor);
  const Texture transmitted = textures_.read(bsdf, "spec_trans", 0, ColourUse::unbounded, Encoding::weight);
  set(result.material, TextureSlot::transmission, transmitted.reference);
  surface.transmissionWeight = static_cast<float>(std::clamp(transmitted.factor.x, 0.0, 1.0));
  surface.isThinWalled = surface.transmissionWeight == 0;
  const double specular = std::clamp(bsdf.number("specular", 0.5), 0.0, 1.0);
  const double ior = bsdf.number("eta", 2 / (1 - std::sqrt(0.08 * specular)) - 1);
  if (bsdf.has("eta") && bsdf.has("specular"))
    throw PlacedError{bsdf.place, "a BSDF \"principled\" has either \"eta\" or \"specular\""};
  surface.ior = static_cast<float>(std::clamp(ior, 1.0, 1e6));
  std::array<Numbers, 3> numbers{textures_.readNumbers(bsdf, "roughness", 0.5),
                                 textures_.readNumbers(bsdf, "anisotropic", 0),
                                 textures_.readNumbers(bsdf, "metallic", 0)};
  putOnOneGrid(bsdf, numbers);
  const Numbers &roughness = numbers[0], &anisotropic = numbers[1], &metallic = numbers[2];
  surface.metalness = metallic.use ? 1 : static_cast<float>(std::clamp(metallic.at(0), 0.0, 1.0));
  result.material.surface = surface;
  const std::string name = fmt::format("principled {} {} {}", roughness.name, anisotropic.name, metallic.name);
  const auto texelAt = [&](std::size_t i) {
    const double alpha = roughness.at(i) * roughness.at(i);
    const double aspect = std::sqrt(1 - 0.9 * std::clamp(anisotropic.at(i), 0.0, 1.0));
    return glm::dvec3(std::max(kMinPrincipledAlpha, alpha / aspect), std::max(kMinPrincipledAlpha, alpha * aspect),
                      metallic.at(i));
  };
  setMicrofacets(bsdf, roughness, name, texelAt, result.material);
  result.isTwoSided = surface.transmissionWeight > 0;
  return result;
}

Bsdf Bsdfs::nested(const Object& bsdf, int depth) {
  const std::vector<const Object*> children = bsdf.nested("bsdf");
  if (children.empty()) throw PlacedError{bsdf.place, fmt::format("{} has no nested BSDF", bsdf.description())};
  return make(*children.front(), depth + 1);
}

Bsdf Bsdfs::twoSided(const Object& bsdf, int depth) {
  const std::vector<const Object*> children = bsdf.nested("bsdf");
  bsdf.ignore({"allow_transmission"}, report_);
  if (children.size() > 2) throw PlacedError{children[2]->place, "a BSDF \"twosided\" has at most two nested BSDFs"};
  Bsdf result = nested(bsdf, depth);
  if (children.size() == 2 && children[0] != children[1]) {
    Bsdf sides{.choices = {result, make(*children[1], depth + 1)}};
    const auto isBySide = [](const Bsdf& side) { return !side.choices.empty() && !side.weight; };
    if (std::ranges::any_of(sides.choices, &Bsdf::isInvisible) || std::ranges::any_of(sides.choices, isBySide)) {
      report_.deviate(children[1]->place, "a side of a surface that is \"null\" or two-sided itself is not rendered",
                      "gives both sides the first BSDF");
    } else {
      result = std::move(sides);
    }
  }
  forEachLeaf(result, [](Bsdf& leaf) { leaf.isTwoSided = true; });
  return result;
}

Bsdf Bsdfs::blended(const Object& bsdf, int depth) {
  Bsdf result = make(bsdf, depth + 1);
  if (result.weight) {
    report_.deviate(bsdf.place, "a blend in a blend is not rendered", "renders its first nested BSDF");
    result = result.choices.front();
  }
  if (result.material.opacity) {
    report_.deviate(bsdf.place, "a BSDF \"mask\" in a blend is not rendered", "renders the BSDF in it");
    result.material.opacity.reset();
  }
  return result;
}

Bsdf Bsdfs::blend(const Object& bsdf, int depth) {
  const std::vector<const Object*> children = bsdf.nested("bsdf");
  if (children.size() != 2) throw PlacedError{bsdf.place, "a BSDF \"blendbsdf\" has two nested BSDFs"};
  const Object* const texture = bsdf.onlyNested("texture");
  if (!texture && !bsdf.has("weight")) throw PlacedError{bsdf.place, "a BSDF \"blendbsdf\" has no \"weight\""};
  const Texture weight = texture ? textures_.readObject(*texture, ColourUse::unbounded, Encoding::alpha)
                                 : textures_.read(bsdf, "weight", 0.5, ColourUse::unbounded, Encoding::alpha);
  const auto factor = static_cast<float>(std::clamp(weight.factor.x, 0.0, 1.0));
  Bsdf first = blended(*children[0], depth), second = blended(*children[1], depth);
  if (first.isInvisible && second.isInvisible) return first;
  if (first.isInvisible) {
    setOpacity(weight, bsdf, second);
    return second;
  }
  if (second.isInvisible && !weight.reference && !weight.attribute) {
    first.material.opacity = scene::Opacity{.factor = 1 - factor};
    return first;
  }
  if (second.isInvisible) {
    report_.deviate(bsdf.place, "a blend by a texture with \"null\" as the second BSDF is not rendered",
                    "renders the first nested BSDF");
    return first;
  }
  if (first.attribute != second.attribute) {
    report_.deviate(bsdf.place, "an attribute of the mesh that only one BSDF of a blend has is not rendered",
                    "colours both BSDFs");
  }
  Bsdf result{.choices = {std::move(first), std::move(second)}, .weight = factor};
  result.attribute = weight.attribute;
  set(result.material, TextureSlot::baseColour, weight.reference);
  return result;
}

Bsdf Bsdfs::mask(const Object& bsdf, int depth) {
  Bsdf result = nested(bsdf, depth);
  const Texture opacity = textures_.read(bsdf, "opacity", 0.5, ColourUse::reflectance, Encoding::alpha);
  if (result.material.opacity || result.isInvisible) {
    throw PlacedError{bsdf.place, "a BSDF \"mask\" contains neither another \"mask\" nor \"null\""};
  }
  setOpacity(opacity, bsdf, result);
  return result;
}

void Bsdfs::setOpacity(const Texture& opacity, const Object& bsdf, Bsdf& result) {
  const float factor = opacity.reference ? 1 : static_cast<float>(std::clamp(opacity.factor.x, 0.0, 1.0));
  result.material.opacity = scene::Opacity{.factor = factor, .texture = opacity.reference};
  if (result.attribute) {
    report_.deviate(bsdf.place, "an opacity of a BSDF that an attribute of the mesh colours is not rendered exactly",
                    "leaves out the alpha of the attribute");
  } else {
    result.attribute = opacity.attribute;
  }
}

/// Sets the normal map of a BSDF, or of each of those between which it is a choice.
void Bsdfs::setNormalMap(const Texture& map, float scale, bool hasHeights, const Object& bsdf, Bsdf& result) {
  for (const char* const name : {"flip_invalid_normals", "use_shadowing_function"}) {
    if (!bsdf.flag(name, true)) report_.omit(fmt::format("\"{}\" false of {}", name, bsdf.description()));
  }
  if (result.isInvisible || !map.reference) return;
  forEachLeaf(result, [&](Bsdf& leaf) {
    makeSurface(leaf.material);
    if (hasNormalMap(leaf.material)) {
      report_.deviate(bsdf.place, "a map of normals or heights of a BSDF that has one already is not rendered",
                      "takes the outer one");
    }
    set(leaf.material, TextureSlot::normal, map.reference);
    leaf.material.normalScale = scale;
    leaf.material.hasHeights = hasHeights;
    leaf.material.hasFacets = false;
  });
}

Bsdf Bsdfs::normalMap(const Object& bsdf, int depth) {
  Bsdf result = nested(bsdf, depth);
  const Texture map = textures_.read(bsdf, "normalmap", 1, ColourUse::unbounded, Encoding::linear);
  setNormalMap(map, 1, false, bsdf, result);
  return result;
}

Bsdf Bsdfs::bumpMap(const Object& bsdf, int depth) {
  Bsdf result = nested(bsdf, depth);
  const Object* const texture = bsdf.onlyNested("texture");
  if (!texture) throw PlacedError{bsdf.place, "a BSDF \"bumpmap\" has a nested texture"};
  const double scale = bsdf.number("scale", 1);
  const Texture map = textures_.readObject(*texture, ColourUse::unbounded, Encoding::height);
  setNormalMap(map, static_cast<float>(scale * map.factor.x), true, bsdf, result);
  return result;
}

Bsdf Bsdfs::replaced(const Object& bsdf, const char* by, int depth) {
  report_.deviate(bsdf.place, fmt::format("{} is not rendered", bsdf.description()), by);
  bsdf.useAll();
  if (!bsdf.nested("bsdf").empty()) return nested(bsdf, depth);
  Bsdf result{.isTwoSided = true};
  result.material.diffuse = scene::DiffuseLobe{.colour = glm::vec3(0.5f)};
  return result;
}

}  // namespace candela::mitsuba
