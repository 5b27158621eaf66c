// Chooses and converts the cameras of a file.
#include "host/formats/gltf/cameras.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host/base/quote.h"
#include "host/base/setting_words.h"

namespace candela::gltf {
namespace {

/// A camera and a visible node that has it.
struct PlacedCamera {
  std::size_t camera;
  std::size_t node;
};

std::vector<PlacedCamera> placedCameras(const Value& root, const NodeTree& nodes) {
  std::vector<PlacedCamera> placed;
  for (const std::size_t node : nodes.visible()) {
    const std::optional<Value> camera = root.require("nodes")[node].find("camera");
    if (camera) placed.push_back({camera->indexInto("cameras", root.sizeOf("cameras")), node});
  }
  return placed;
}

std::string nameOf(const Value& root, const char* list, std::size_t index) {
  return root.require(list)[index].textOr("name", "");
}

bool answers(const Value& root, const PlacedCamera& placed, const std::string& wish) {
  return wish == std::to_string(placed.camera) || wish == nameOf(root, "cameras", placed.camera) ||
         wish == nameOf(root, "nodes", placed.node);
}

std::string listOf(const Value& root, const std::vector<PlacedCamera>& all) {
  constexpr std::size_t kShown = 20;
  std::string text;
  for (std::size_t i = 0; i < all.size() && i < kShown; ++i) {
    const std::string camera = nameOf(root, "cameras", all[i].camera);
    const std::string name = camera.empty() ? nameOf(root, "nodes", all[i].node) : camera;
    text += fmt::format("{}{}", text.empty() ? "" : ", ", all[i].camera);
    if (!name.empty()) text += " " + scene::quote(name);
  }
  if (text.empty()) return "the scene has no camera";
  return "the scene's cameras are " + text + (all.size() > kShown ? " and others" : "");
}

View viewOf(const Value& root, const NodeTree& nodes, const PlacedCamera& placed,
            const std::optional<scene::Bounds>& bounds) {
  const Value camera = root.require("cameras")[placed.camera];
  const std::string name = nameOf(root, "cameras", placed.camera);
  return {cameraAt(camera, nodes.world(placed.node), bounds),
          fmt::format("camera {}{} of the file", placed.camera, name.empty() ? "" : " " + scene::quote(name))};
}

View framingView(const std::optional<scene::Bounds>& bounds) {
  return {scene::framingCamera(bounds), "a view that frames the model"};
}

}  // namespace

View chooseView(const Value& root, const NodeTree& nodes, const std::optional<std::string>& wish,
                const std::optional<scene::Bounds>& bounds,
                const std::function<std::optional<scene::Bounds>()>& framed) {
  const std::vector<PlacedCamera> all = placedCameras(root, nodes);
  if (wish == "none" || (!wish && all.empty())) return framingView(framed());
  if (!wish) return viewOf(root, nodes, all.front(), bounds);
  const auto found = std::ranges::find_if(all,
                                          [&](const PlacedCamera& placed) { return answers(root, placed, *wish); });
  if (found == all.end()) {
    throw FileError(fmt::format("no camera {}; {}; {} frames the model", scene::quote(*wish), listOf(root, all),
                                settingWords("camera", "none")));
  }
  return viewOf(root, nodes, *found, bounds);
}

}  // namespace candela::gltf
