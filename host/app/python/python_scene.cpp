// Reads scenes from files and from arrays.
#include "host/app/python/python_scene.h"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <nlohmann/json.hpp>

#include "host/app/python/file_names.h"
#include "host/app/python/json.h"
#include "host/app/python/options.h"
#include "host/app/python/running_call.h"
#include "host/app/python/watched.h"
#include "host/base/hash.h"
#include "host/base/hash_text.h"
#include "host/base/json_text.h"
#include "host/formats/load_scene.h"
#include "host/formats/scene_report.h"

namespace candela::python {
namespace {

namespace py = pybind11;

using Loaded = std::shared_ptr<PythonScene>;

Loaded finish(scene::LoadedScene loaded, cli::SceneArguments arguments, const Log& log) {
  for (const scene::Diagnostic& warning : loaded.warnings) log.warning(toString(warning));
  requireCamera(loaded.scene);
  return std::make_shared<PythonScene>(std::move(loaded), std::move(arguments));
}

/// Runs `read` without the GIL, and passes its messages on.
template <class Read>
Loaded readWatched(const Read& read) {
  PythonLog log;
  Loaded loaded;
  runWatched([&](const Watch&) { loaded = read(log); });
  log.passOn();
  return loaded;
}

Loaded load(const py::object& file, const py::kwargs& options) {
  auto arguments = argumentsOf<cli::SceneArguments>(kLoadOptions, options);
  arguments.files = {fileOf("file", file)};
  return readWatched([&](const Log& log) {
    scene::LoadedScene loaded = formats::loadScene(arguments.files.front(), arguments.loadOptions);
    loaded.files.emplace_back(arguments.files.front());
    return finish(std::move(loaded), arguments, log);
  });
}

glm::vec3 vectorOf(const py::handle& value) {
  const auto [x, y, z] = value.cast<std::tuple<float, float, float>>();
  return {x, y, z};
}

/// The camera that candela._arrays has checked.
scene::Camera cameraOf(const py::dict& given) {
  scene::Camera camera;
  camera.from = vectorOf(given["from"]);
  camera.at = vectorOf(given["at"]);
  camera.up = vectorOf(given["up"]);
  camera.angle = given["angle"].cast<float>();
  std::tie(camera.width, camera.height) = given["resolution"].cast<std::pair<std::uint32_t, std::uint32_t>>();
  camera.aperture = given["aperture"].cast<float>();
  camera.focal = given["focal"].cast<float>();
  camera.orthographicHeight = given["orthographic_height"].cast<std::optional<float>>();
  return camera;
}

std::uint64_t hashOf(const scene::Camera& camera, std::uint64_t hash) {
  const auto vector = [](const glm::vec3& v) { return fmt::format("{} {} {}", v.x, v.y, v.z); };
  return fnv1aOfText(fmt::format("camera {} {} {} {} {}x{} {} {} {}", vector(camera.from), vector(camera.at),
                                 vector(camera.up), camera.angle, camera.width, camera.height, camera.aperture,
                                 camera.focal, camera.orthographicHeight.value_or(0)),
                     hash);
}

void setCamera(const std::optional<scene::Camera>& camera, scene::Scene& scene) {
  if (!camera) return;
  scene.camera = camera;
  scene.hash = hashOf(*camera, scene.hash);
}

// candela._arrays turns arrays into a glTF file in memory, so that every rule for files applies to them.
Loaded fromArrays(const py::args& positional, const py::kwargs& keywords) {
  const RunningCall call;
  const py::dict built = py::module_::import("candela._arrays").attr("build")(*positional, **keywords);
  auto arguments = argumentsOf<cli::SceneArguments>(kSceneOptions, py::kwargs(built["options"]));
  arguments.files = {built["name"].cast<std::string>()};
  const auto bytes = built["glb"].cast<std::string>();
  const std::optional<scene::Camera> camera = built["camera"].is_none() ? std::nullopt
                                                                        : std::optional(cameraOf(built["camera"]));
  return readWatched([&](const Log& log) {
    scene::LoadedScene loaded = formats::loadScene({bytes, arguments.files.front(), "."}, arguments.loadOptions);
    setCamera(camera, loaded.scene);
    return finish(std::move(loaded), arguments, log);
  });
}

py::str sceneText(const PythonScene& scene) {
  return textOf(fmt::format("<candela.Scene {}: {} primitives, hash {}>", scene.scene->name,
                            scene.scene->primitives.size(), hashText(scene.scene->hash)));
}

}  // namespace

PythonScene::PythonScene(scene::LoadedScene loaded, cli::SceneArguments arguments)
    : loading(std::move(arguments)), loaded_(std::make_shared<const scene::LoadedScene>(std::move(loaded))) {
  scene = std::shared_ptr<const scene::Scene>(loaded_, &loaded_->scene);
}

py::object PythonScene::report() const {
  {
    const py::gil_scoped_release released;
    std::call_once(isReported_, [&] { report_ = jsonText(toJson(scene::makeReport(*loaded_))); });
  }
  return fromJson(report_);
}

cli::RenderJob PythonScene::jobOf(cli::TracingCommand command, const Log& log) const {
  const auto complete = [&](cli::SceneArguments& arguments) {
    arguments.files = loading.files;
    arguments.loadOptions = loading.loadOptions;
    arguments.given.insert(loading.given.begin(), loading.given.end());
  };
  std::visit(complete, command);
  return cli::jobOf(command, scene, log);
}

void defineScene(py::module_& module) {
  const std::string options = helpOf(kLoadOptions);
  py::class_<PythonScene, Loaded>(module, "Scene", py::is_final(),
                                  "A scene that is ready to be rendered. It does not change.")
      .def(py::init(&fromArrays),
           ("Scene(vertices, faces, materials=(), face_materials=None, *, normals=None, texcoords=None, colours=None, "
            "lights=(), camera=None, name='scene', **options)\n\nA scene of triangles; see docs/python.md.\n\n" +
            helpOf(kSceneOptions))
               .c_str())
      .def_property_readonly("name", [](const PythonScene& scene) { return textOf(scene.scene->name); })
      .def_property_readonly("hash", [](const PythonScene& scene) { return hashText(scene.scene->hash); })
      .def_property_readonly("report", &PythonScene::report)
      .def("__repr__", &sceneText);
  module.def("load", &load, py::arg("file"), py::pos_only(),
             ("load(file, /, **options) -> Scene\n\nReads a scene: glTF, Mitsuba, OBJ, PLY, P3F or NFF.\n\n" + options)
                 .c_str());
}

}  // namespace candela::python
