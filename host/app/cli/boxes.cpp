// `candela boxes`: writes the boxes of a scene's BVH as a scene.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "host/app/cli/commands.h"
#include "host/app/cli/file_kinds.h"
#include "host/app/cli/scene_output.h"
#include "host/app/cli/separate_files.h"
#include "host/base/counted.h"
#include "host/formats/load_scene.h"
#include "host/image/colour_map.h"
#include "host/image/colour_transfer.h"
#include "host/scene/generate/kinds.h"
#include "host/scene/generate/nff_writer.h"
#include "host/scene/scene.h"
#include "host/trace/accel/bvh_levels.h"
#include "host/trace/accel/primitive_bounds.h"
#include "host/trace/flatten/flatten_hierarchy.h"

namespace candela::cli {
namespace {

/// Maximum number of primitives per box. Edges without length are omitted.
constexpr std::uint64_t kBoxEdges = 12;

using generate::NffWriter;

constexpr double kEdgeWidth = 1.0 / 250;  // fraction of the height of the picture
constexpr double kOrthographicAngle = 1;  // degrees
constexpr double kDeepestColour = 0.45;   // position in the colour map; colours below it are too dark on black

double halfAngleTangent(double angle) { return std::tan(glm::radians(angle) / 2); }

/// Returns the view. NFF has no orthographic cameras. A camera that is far away, and shows the same part of the plane
/// through the target, has rays that are nearly parallel.
generate::View viewOf(const scene::Camera& camera) {
  generate::View view{camera.from, camera.at, camera.up, camera.angle, camera.hither, camera.width, camera.height};
  if (!camera.orthographicHeight) return view;
  view.angle = kOrthographicAngle;
  const double distance = *camera.orthographicHeight / 2 / halfAngleTangent(view.angle);
  view.from = view.at + distance * glm::normalize(view.from - view.at);
  return view;
}

/// Returns the radius of edges. It depends on the size of the picture, since the scene may extend far beyond what is
/// visible.
double edgeRadius(const generate::View& view) {
  const double pictureHeight = 2 * glm::length(view.at - view.from) * halfAngleTangent(view.angle);
  return pictureHeight * kEdgeWidth / 2;
}

void writeColour(NffWriter& out, std::uint32_t depth, std::uint32_t deepest) {
  const double fraction = static_cast<double>(depth) / std::max(deepest, 1u);
  const glm::dvec3 signal = image::magma(1 - fraction * (1 - kDeepestColour));
  out.surface({{image::srgbDecode(signal.x), image::srgbDecode(signal.y), image::srgbDecode(signal.z)}, 1, 0, 0, 0, 1});
}

/// Writes the four edges along `axis`, unless they have no length.
void writeEdges(NffWriter& out, const accel::Aabb& box, int axis, double radius) {
  if (box.min[axis] == box.max[axis]) return;
  const int across = (axis + 1) % 3;
  const int along = (axis + 2) % 3;
  for (const float a : {box.min[across], box.max[across]}) {
    for (const float b : {box.min[along], box.max[along]}) {
      glm::dvec3 start(0);
      start[across] = a;
      start[along] = b;
      glm::dvec3 end = start;
      start[axis] = box.min[axis];
      end[axis] = box.max[axis];
      out.cone(start, radius, end, radius);
    }
  }
}

/// Writes a scene with the view of `camera` but without its lens, with a light at the eye, so that both tracers show
/// the edges, and with a black background. The thickness of edges is 1/250 of the height of the picture at the point
/// looked at. Their colours depend on the depth, from pale yellow (the root) to purple (`deepest`, in steps from the
/// root).
void writeBoxScene(NffWriter& out, const scene::Camera& camera, std::span<const accel::LevelBox> boxes,
                   std::uint32_t deepest) {
  out.background({0, 0, 0});
  const generate::View view = viewOf(camera);
  out.view(view);
  out.light(view.from);
  const double radius = edgeRadius(view);
  for (const accel::LevelBox& box : boxes) {
    writeColour(out, box.depth, deepest);
    for (int axis = 0; axis < 3; ++axis) writeEdges(out, box.bounds, axis, radius);
  }
  out.finish();
}

void requireReadableSize(std::size_t boxCount) {
  constexpr std::uint64_t kMaxBoxes = generate::kMaxPrimitives / kBoxEdges;
  if (boxCount <= kMaxBoxes) return;
  throw FileError(fmt::format("{} boxes have more than {} edges; use --depth N to draw one level of the BVH", boxCount,
                              generate::kMaxPrimitives));
}

}  // namespace

ExitCode run(const BoxesArguments& arguments, const Log& log) {
  const scene::LoadedScene loaded = formats::loadScene(arguments.files.front(), arguments.loadOptions);
  for (const scene::Diagnostic& warning : loaded.warnings) log.warning(toString(warning));
  requireUnread(arguments, loaded.files);
  refuseOtherFormat(arguments.generatedFile, {".nff", ".p3f"}, "the boxes are written as NFF");
  requireCamera(loaded.scene);
  const accel::Bvh bvh = flatten::buildHierarchy(accel::boundPrimitives(loaded.scene).bounds,
                                                 arguments.request.structure.bvhSplit,
                                                 arguments.request.structure.bvhQuality);
  const std::vector<accel::LevelBox> boxes = levelBoxes(bvh, arguments.depth);
  requireReadableSize(boxes.size());
  const std::uint32_t deepest = quality(bvh).depth;
  writeSceneText(arguments.generatedFile, [&](const auto& sink) {
    generate::NffWriter out(sink, std::numeric_limits<float>::max_digits10);
    writeBoxScene(out, *loaded.scene.camera, boxes, deepest);
  });
  log.note(fmt::format("{}: {} of {} boxes; the BVH has {}", loaded.scene.name, boxes.size(), bvh.nodes.size(),
                       counted(bvh.nodes.empty() ? 0 : deepest + 1, "level")));
  return ExitCode::done;
}

}  // namespace candela::cli
