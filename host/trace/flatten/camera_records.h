// The records of a flat scene that depend on the camera, so that it can move without flattening the scene again.
#pragma once
#include "host/trace/flatten/flat_rows.h"
#include "host/trace/flatten/flat_scene.h"

namespace candela::flatten {

/// Consecutive records of the scene buffer, starting at record `first`. It is empty if no record depends on the camera.
struct RecordSpan {
  std::uint32_t first = 0;
  Rows rows;
};

/// Copies of the records that moveCamera() changes. Spheres are anchored at the point nearest to the eye
/// (docs/architecture.md), and the Whitted tracer's square lights face the camera's target.
struct CameraRecords {
  gpu::RenderConstants constants{};
  std::array<gpu::uvec4, gpu::kUniformRows> slotRows{};  ///< FlatScene::slotRows
  RecordSpan primitives;                                 ///< from the first to the last sphere
  RecordSpan pointLights;                                ///< of the Whitted tracer
};

CameraRecords cameraRecordsOf(const scene::Scene& scene, const FlatScene& flat, const render::ImageSettings& image);

/// Sets the records and the shape for `camera`; they equal those of a scene flattened with it. `scene` and `image` must
/// be those from which they were made.
void moveCamera(const scene::Scene& scene, const scene::Camera& camera, const render::ImageSettings& image,
                CameraRecords& records, SceneShape& shape);

}  // namespace candela::flatten
