// `candela boxes`: writes the boxes of a scene's BVH as a scene.
#include <fmt/format.h>

#include <limits>

#include "host/app/cli/box_scene.h"
#include "host/app/cli/commands.h"
#include "host/app/cli/file_kinds.h"
#include "host/app/cli/scene_output.h"
#include "host/app/cli/separate_files.h"
#include "host/base/counted.h"
#include "host/formats/load_scene.h"
#include "host/scene/generate/kinds.h"
#include "host/trace/accel/primitive_bounds.h"
#include "host/trace/flatten/flatten_hierarchy.h"

namespace candela::cli {
namespace {

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
