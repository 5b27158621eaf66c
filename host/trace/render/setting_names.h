// The names of the values of settings, as options, films and reports write them.
#pragma once
#include <fmt/format.h>

#include <array>
#include <string>

#include "host/trace/render/settings.h"

namespace candela::render {

template <class T>
struct NamedValue {
  const char* name;
  T value;
};
template <class T>
NamedValue(const char*, T) -> NamedValue<T>;  // Clang deduces the arguments of aggregates from version 17 on

/// The values of an enumeration that have names, in the order in which help lists them.
template <class T>
inline constexpr std::array<NamedValue<T>, 0> kNamesOf{};

/// Returns the name of a value; empty if it has none.
template <class T>
requires(!kNamesOf<T>.empty()) constexpr const char* nameOf(T value) {
  for (const NamedValue<T>& named : kNamesOf<T>) {
    if (named.value == value) return named.name;
  }
  return "";
}

template <>
inline constexpr std::array kNamesOf<Integrator>{
    NamedValue{"path", Integrator::path},     NamedValue{"whitted", Integrator::whitted},
    NamedValue{"ao", Integrator::ao},         NamedValue{"normal", Integrator::normal},
    NamedValue{"albedo", Integrator::albedo}, NamedValue{"depth", Integrator::depth},
    NamedValue{"id", Integrator::id},         NamedValue{"cost", Integrator::cost}};
template <>
inline constexpr std::array kNamesOf<SamplerKind>{NamedValue{"independent", SamplerKind::independent},
                                                  NamedValue{"stratified", SamplerKind::stratified},
                                                  NamedValue{"sobol", SamplerKind::sobol}};
template <>
inline constexpr std::array kNamesOf<FilterKind>{NamedValue{"box", FilterKind::box},
                                                 NamedValue{"tent", FilterKind::tent},
                                                 NamedValue{"gaussian", FilterKind::gaussian}};
template <>
inline constexpr std::array kNamesOf<LightSelection>{NamedValue{"power", LightSelection::power},
                                                     NamedValue{"tree", LightSelection::tree}};
template <>
inline constexpr std::array kNamesOf<LensKind>{NamedValue{"disc", LensKind::disc},
                                               NamedValue{"square", LensKind::square}};
template <>
inline constexpr std::array kNamesOf<PixelOrigin>{NamedValue{"centre", PixelOrigin::centre},
                                                  NamedValue{"corner", PixelOrigin::corner}};
template <>
inline constexpr std::array kNamesOf<Backdrop>{NamedValue{"env", Backdrop::environment},
                                               NamedValue{"colour", Backdrop::colour},
                                               NamedValue{"none", Backdrop::none}};
template <>
inline constexpr std::array kNamesOf<AccelKind>{NamedValue{"none", AccelKind::none},
                                                NamedValue{"grid", AccelKind::grid}, NamedValue{"bvh", AccelKind::bvh}};
template <>
inline constexpr std::array kNamesOf<BvhSplit>{NamedValue{"sah", BvhSplit::sah},
                                               NamedValue{"midpoint", BvhSplit::midpoint}};
template <>
inline constexpr std::array kNamesOf<BuildQuality>{NamedValue{"fast", BuildQuality::fast},
                                                   NamedValue{"default", BuildQuality::standard},
                                                   NamedValue{"high", BuildQuality::high}};
template <>
inline constexpr std::array kNamesOf<BvhLayout>{NamedValue{"auto", BvhLayout::automatic},
                                                NamedValue{"bvh2", BvhLayout::bvh2},
                                                NamedValue{"cwbvh", BvhLayout::cwbvh}};
template <>
inline constexpr std::array kNamesOf<SceneLoads>{NamedValue{"auto", SceneLoads::automatic},
                                                 NamedValue{"texel", SceneLoads::texel},
                                                 NamedValue{"storage", SceneLoads::storage}};
template <>
inline constexpr std::array kNamesOf<KernelKind>{NamedValue{"auto", KernelKind::automatic},
                                                 NamedValue{"megakernel", KernelKind::megakernel},
                                                 NamedValue{"wavefront", KernelKind::wavefront}};

/// Returns the name of a filter, for a Gaussian with its standard deviation: "gaussian:0.5".
inline std::string filterText(const PixelFilter& filter) {
  const char* name = nameOf(filter.kind);
  return filter.kind == FilterKind::gaussian ? fmt::format("{}:{}", name, filter.deviation) : name;
}

}  // namespace candela::render
