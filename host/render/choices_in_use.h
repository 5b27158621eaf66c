// The choices that a session has made where its settings leave them open, and their names in reports.
#pragma once
#include <optional>

#include "host/render/settings.h"

namespace candela::render {

/// The rule that split the nodes of the BVH in use. none: there is no BVH; median: the reference's own rule.
enum class SplitInUse { none, sah, midpoint, median };

/// The records in which a device reads the primitives of the scene. none: a grid, brute force, a BVH of one leaf, or
/// the reference; list: the scene is small, and all primitives are tested sequentially; bvh2, cwbvh: the nodes of a
/// BVH.
enum class LayoutInUse { none, list, bvh2, cwbvh };

/// The code that traces: the reference, or one of the kernels of a device. replay: it traces one sample and records it.
enum class KernelInUse { reference, megakernel, wavefront, whitted, views, replay };

/// Returns the name of an acceleration structure as on the command line: "none", "grid" or "bvh".
constexpr const char* nameOf(AccelKind accel) {
  switch (accel) {
    case AccelKind::none:
      return "none";
    case AccelKind::grid:
      return "grid";
    case AccelKind::bvh:
      break;
  }
  return "bvh";
}

/// Returns "sah", "midpoint" or "median"; empty without a BVH.
constexpr const char* nameOf(SplitInUse split) {
  switch (split) {
    case SplitInUse::sah:
      return "sah";
    case SplitInUse::midpoint:
      return "midpoint";
    case SplitInUse::median:
      return "median";
    case SplitInUse::none:
      break;
  }
  return "";
}

/// Returns "list", "bvh2" or "cwbvh"; empty if there is none.
constexpr const char* nameOf(LayoutInUse layout) {
  switch (layout) {
    case LayoutInUse::list:
      return "list";
    case LayoutInUse::bvh2:
      return "bvh2";
    case LayoutInUse::cwbvh:
      return "cwbvh";
    case LayoutInUse::none:
      break;
  }
  return "";
}

constexpr const char* nameOf(KernelInUse kernel) {
  switch (kernel) {
    case KernelInUse::megakernel:
      return "megakernel";
    case KernelInUse::wavefront:
      return "wavefront";
    case KernelInUse::whitted:
      return "whitted";
    case KernelInUse::views:
      return "views";
    case KernelInUse::replay:
      return "replay";
    case KernelInUse::reference:
      break;
  }
  return "reference";
}

/// Returns the name as on the command line: "fast", "default" or "high"; empty if there is none.
constexpr const char* nameOf(std::optional<BuildQuality> quality) {
  if (!quality) return "";
  if (*quality == BuildQuality::standard) return "default";
  return *quality == BuildQuality::fast ? "fast" : "high";
}

/// Returns "texel" or "storage"; empty if the scene is read through neither. `loads` must not be automatic.
constexpr const char* nameOf(std::optional<SceneLoads> loads) {
  if (!loads) return "";
  return *loads == SceneLoads::texel ? "texel" : "storage";
}

}  // namespace candela::render
