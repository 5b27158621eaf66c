// Moves the camera of a flat scene.
#include "host/trace/flatten/camera_records.h"

#include <algorithm>
#include <span>

#include "host/trace/flatten/camera_constants.h"
#include "host/trace/flatten/flatten_primitives.h"
#include "host/trace/flatten/flatten_sections.h"

namespace candela::flatten {
namespace {

bool isSphere(std::span<const gpu::uvec4> slot) { return (slot[2].w & gpu::kKindMask) == gpu::kKindSphere; }

std::span<gpu::uvec4> slotOf(std::span<gpu::uvec4> rows, std::size_t slot) {
  return rows.subspan(slot * gpu::kPrimitiveRows, gpu::kPrimitiveRows);
}

// Returns the records from the first to the last sphere.
RecordSpan sphereSpan(const FlatScene& flat) {
  if (!flat.shape.features.spheres) return {};
  const std::uint32_t base = flat.constants.firstPrimitiveRow;
  const std::span all = std::span(flat.rows).subspan(base, std::size_t{flat.shape.slotCount} * gpu::kPrimitiveRows);
  const auto hasSphere = [&](std::size_t slot) {
    return isSphere(all.subspan(slot * gpu::kPrimitiveRows, gpu::kPrimitiveRows));
  };
  std::size_t first = 0;
  std::size_t end = flat.shape.slotCount;
  while (!hasSphere(first)) ++first;
  while (!hasSphere(end - 1)) --end;
  const std::span spheres = all.subspan(first * gpu::kPrimitiveRows, (end - first) * gpu::kPrimitiveRows);
  return {base + static_cast<std::uint32_t>(first) * gpu::kPrimitiveRows, Rows(spheres.begin(), spheres.end())};
}

void placeSpheres(const scene::Scene& scene, const scene::Camera& camera, std::span<gpu::uvec4> rows) {
  for (std::size_t slot = 0; slot < rows.size() / gpu::kPrimitiveRows; ++slot) {
    const std::span<gpu::uvec4> records = slotOf(rows, slot);
    if (!isSphere(records)) continue;
    const scene::Primitive& primitive = scene.primitives[records[1].w];
    placeSphere(scene.spheres[primitive.index], camera.from, records.first<2>());
  }
}

}  // namespace

CameraRecords cameraRecordsOf(const scene::Scene& scene, const FlatScene& flat, const render::ImageSettings& image) {
  CameraRecords records{
      .constants = flat.constants, .slotRows = flat.slotRows, .primitives = sphereSpan(flat), .pointLights = {}};
  if (image.integrator != render::Integrator::whitted || image.lightSize == 0) return records;
  records.pointLights = {flat.constants.firstLightRow,
                         pointLightRows(scene.pointLights, *scene.camera, image.lightSize)};
  return records;
}

void moveCamera(const scene::Scene& scene, const scene::Camera& camera, const render::ImageSettings& image,
                CameraRecords& records, SceneShape& shape) {
  setCamera(records.constants, camera, image);
  noteCamera(camera, records.constants, shape);
  placeSpheres(scene, camera, std::span(records.slotRows).first(std::size_t{shape.uniformSlots} * gpu::kPrimitiveRows));
  placeSpheres(scene, camera, records.primitives.rows);
  if (records.pointLights.rows.empty()) return;
  records.pointLights.rows = pointLightRows(scene.pointLights, camera, image.lightSize);
}

}  // namespace candela::flatten
