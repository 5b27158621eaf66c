// The choices that a session has made where its settings leave them open, and their names in reports.
#pragma once
#include <optional>

#include "host/trace/render/setting_names.h"

namespace candela::render {

/// The rule that split the nodes of the BVH in use. none: there is no BVH; median: the reference's own rule.
enum class SplitInUse { none, sah, midpoint, median };

/// The records in which a device reads the primitives of the scene. none: a grid, brute force, a BVH of one leaf, or
/// the reference; list: the scene is small, and all primitives are tested sequentially; bvh2, cwbvh: the nodes of a
/// BVH.
enum class LayoutInUse { none, list, bvh2, cwbvh };

/// The code that traces: the reference, or one of the kernels of a device. replay: it traces one sample and records it.
enum class KernelInUse { reference, megakernel, wavefront, whitted, views, replay };

template <>
inline constexpr std::array kNamesOf<SplitInUse>{NamedValue{"sah", SplitInUse::sah},
                                                 NamedValue{"midpoint", SplitInUse::midpoint},
                                                 NamedValue{"median", SplitInUse::median}};
template <>
inline constexpr std::array kNamesOf<LayoutInUse>{NamedValue{"list", LayoutInUse::list},
                                                  NamedValue{"bvh2", LayoutInUse::bvh2},
                                                  NamedValue{"cwbvh", LayoutInUse::cwbvh}};
template <>
inline constexpr std::array kNamesOf<KernelInUse>{
    NamedValue{"reference", KernelInUse::reference}, NamedValue{"megakernel", KernelInUse::megakernel},
    NamedValue{"wavefront", KernelInUse::wavefront}, NamedValue{"whitted", KernelInUse::whitted},
    NamedValue{"views", KernelInUse::views},         NamedValue{"replay", KernelInUse::replay}};

/// Returns the name of a choice; empty if the session has none.
template <class T>
constexpr const char* nameOf(const std::optional<T>& choice) {
  return choice ? nameOf(*choice) : "";
}

}  // namespace candela::render
