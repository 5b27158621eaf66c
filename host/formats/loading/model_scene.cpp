// Adds a view and a light to models.
#include "host/formats/loading/model_scene.h"

#include <fmt/format.h>

#include "host/base/setting_words.h"
#include "host/formats/loading/default_light.h"
#include "host/formats/loading/framing.h"
#include "host/formats/loading/scene_checks.h"
#include "host/scene/bounds.h"

namespace candela::scene {

FileFacts completeModel(Scene& scene, const LoadOptions& options, DiagnosticLog& log) {
  const bool namesCamera = options.camera && *options.camera != "none";
  if (namesCamera || options.time) {
    log.warn("options", {},
             fmt::format("{} and {} have no effect: the format has neither cameras nor animations",
                         settingWords("camera"), settingWords("time")));
  }
  const std::optional<Bounds> bounds = boundsOf(scene);
  scene.camera = framingCamera(bounds);
  warnOfExtent(bounds, log);
  FileFacts facts{{"view", "a view that frames the model"}};
  facts.emplace_back("light", lightUp(scene, defaultLightOf(scene, bounds), options));
  warnOfShadows(scene, log);
  setReach(bounds, scene);
  checkScene(scene, options, log);
  return facts;
}

Material plainMaterial(bool hasColours) {
  constexpr float kAlbedo = 0.8f;
  Material material;
  material.diffuse = DiffuseLobe{.colour = glm::vec3(hasColours ? 1.0f : kAlbedo)};
  return material;
}

}  // namespace candela::scene
