// Emitters that are no shapes.
#pragma once
#include "host/formats/loading/load.h"
#include "host/formats/mitsuba/textures.h"
#include "host/scene/scene.h"

namespace candela::mitsuba {

/// The emission of a shape: <emitter type="area">.
Texture areaEmission(const Object& emitter, Textures& textures, Report& report);

/// Adds the lights, the background and the environment of a scene.
class Emitters {
 public:
  Emitters(const scene::SceneFile& file, const Description& description, const scene::LoadOptions& options,
           scene::PathGuard& guard, Report& report, scene::Scene& scene)
      : file_(file), description_(description), options_(options), guard_(guard), report_(report), scene_(scene) {}

  /// Throws PlacedError.
  void add(const Object& emitter);

 private:
  glm::dvec3 colour(const Object& emitter, const char* name);
  void addPoint(const Object& emitter);
  void addSpot(const Object& emitter);
  void addDirectional(const Object& emitter);
  void addConstant(const Object& emitter);
  void addEnvironment(const Object& emitter);
  void addSurrounding(const Object& emitter);

  const scene::SceneFile& file_;
  const Description& description_;
  const scene::LoadOptions& options_;
  scene::PathGuard& guard_;
  Report& report_;
  scene::Scene& scene_;
  bool isSurrounded_ = false;
};

}  // namespace candela::mitsuba
