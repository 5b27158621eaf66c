// The scene in the format that the device reads: one array of 16-byte records (shaders/shared/scene_rows.h), and the
// constants with the first indices of its sections.
#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "host/scene/scene.h"
#include "host/trace/flatten/scene_shape.h"
#include "host/trace/flatten/small_scene.h"
#include "shaders/shared/render_data.h"

namespace candela::flatten {

/// Returns all features of a scene except those that noteLights() and noteCamera() set.
SceneFeatures featuresOf(const scene::Scene& scene, render::Integrator integrator);

inline constexpr std::uint32_t kAnyGridSide = 0xffffffffu;

/// A scene that is ready to be uploaded. Only its shape is needed afterwards.
struct FlatScene {
  SceneShape shape;
  std::vector<gpu::uvec4> rows;
  gpu::RenderConstants constants{};
  std::array<gpu::uvec4, gpu::kUniformRows> slotRows{};  ///< records of the primitives of a small scene
  double structureSeconds = 0;                           ///< time of building the acceleration structure
  std::map<std::string, double> structureQuality;
};

/// Limits of a flat scene that depend on the device.
struct FlattenLimits {
  std::uint32_t maxGridSide = kAnyGridSide;  ///< cells along an axis of a grid
  SmallSceneRule smallScene;
};

/// Computes every record in double precision from the scene's binary32 values, rounding once. The scene must have a
/// camera. Throws FileError if it exceeds a limit of the layout.
FlatScene flattenScene(const scene::Scene& scene, const render::RenderSettings& settings,
                       const FlattenLimits& limits = {});

}  // namespace candela::flatten
