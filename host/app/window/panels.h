// The panels of the viewer: the values that they show, and the user's choices.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "host/app/view/engine.h"
#include "host/app/view/view_state.h"
#include "shaders/shared/window_data.h"

namespace candela::window {

/// The values that the panels show besides the state.
struct PanelInput {
  const view::EngineView& engine;
  const std::vector<std::string>& devices;
  gpu::PointedValues pointed;
  view::Mode shownMode;  ///< that of the picture, which is the reference while the device is prepared
  double response = 0;   ///< seconds of the last response to input
  bool presentsFromDevice = false;
  bool isPlaying = false;  ///< the animation
};

/// The user's actions in the panels in one frame.
struct PanelChoice {
  std::optional<view::Choice> choice;
  std::optional<view::Mode> mode;
  std::optional<double> time;       ///< in the animation
  bool playOrPause = false;         ///< the animation
  std::optional<std::string> file;  ///< to save
  bool reload = false;
  bool copyCamera = false;
  bool inspect = false;       ///< the inspected sample changed
  bool inspectWorst = false;  ///< the pixel that differs most is inspected
};

class Panels {
 public:
  /// `file` is the first proposal for the name of a saved image.
  explicit Panels(const std::string& file);

  /// Draws the panels into the current frame of Dear ImGui.
  PanelChoice draw(view::ViewState& state, const PanelInput& input);
  /// The file that the save button names.
  std::string file() const { return file_.data(); }

 private:
  void drawRender(const PanelInput& input, PanelChoice& choice);
  void drawView(view::ViewState& state, const PanelInput& input, PanelChoice& choice);
  void drawTime(const PanelInput& input, PanelChoice& choice);
  void drawDifference(view::ViewState& state, const PanelInput& input, PanelChoice& choice);
  void drawLayer(const PanelInput& input, PanelChoice& choice);
  void drawPixel(view::ViewState& state, const PanelInput& input, PanelChoice& choice);
  void drawPath(view::ViewState& state, const PanelInput& input, PanelChoice& choice);
  void drawSave(const PanelInput& input, PanelChoice& choice);

  std::array<char, 256> file_{};
};

/// Draws the names of the sides beside the divider.
void drawDivider(const view::ViewState& state, const PanelInput& input);

}  // namespace candela::window
