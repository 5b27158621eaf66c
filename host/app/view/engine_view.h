// The state that the engine shows, and the choices of a user.
#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "host/app/view/picture.h"
#include "host/app/view/shown_layer.h"
#include "host/app/view/view_state.h"
#include "host/trace/render/renderer.h"

namespace candela::view {

/// The choices of a user for a render, besides the camera.
struct Choice {
  std::string device;  ///< as --device; kReferenceDevice: only the reference
  render::Integrator integrator = render::Integrator::path;
  ShownLayer layer{};            ///< only with Integrator::path, because the others have no layers
  std::optional<double> time{};  ///< in the animation, in seconds; empty: at rest

  bool usesReference() const { return device == render::kReferenceDevice; }
  bool operator==(const Choice&) const = default;
};

/// Returns the choice with a layer, or the picture. A layer selects Integrator::path.
Choice withLayer(Choice choice, ShownLayer layer);
/// Returns the choice with an integrator. All but Integrator::path show the picture.
Choice withIntegrator(Choice choice, render::Integrator integrator);

/// The state and the picture of one side.
struct SideView {
  bool hasSession = false;
  std::uint32_t scale = 0;                 ///< of the picture; 0: none yet
  std::uint32_t samples = 0;               ///< of each pixel
  double seconds = 0;                      ///< of rendering since the last change of the view
  bool isOnDevice = false;                 ///< the picture is the one that EngineHooks::showOnDevice last showed
  std::shared_ptr<const Picture> picture;  ///< null if it is on the device, or there is none
};

/// A consistent state of the engine, for the window.
struct EngineView {
  std::uint64_t serial = 0;
  Choice choice;
  render::Extent size;
  std::uint32_t sampleCount = 0;
  std::string deviceName;
  bool isPreparing = false;  ///< the device's session is not ready, and the reference is shown
  std::array<SideView, kSideCount> sides;
  std::uint64_t viewSerial = 0;  ///< number of setCamera() that the pictures show
  std::optional<PictureDifference> difference;
  LayerRange layerRange;  ///< of the layers `depth` and `position`
  /// Names of the ids of a matte; null while another layer is shown.
  std::shared_ptr<const std::map<std::uint32_t, std::string>> matteNames;
  float falseColourScale = 1;                 ///< image::falseColourScale() of the integrators `depth` and `cost`
  std::string message;                        ///< about the last save, reload or failure; empty: none
  bool isError = false;                       ///< of `message`
  render::PixelSample explained;              ///< by `explanation`
  std::string explanation;                    ///< text of `candela explain`
  std::shared_ptr<const scene::Scene> scene;  ///< changes when a file was read again, and with the time
  std::optional<double> animationEnd;         ///< in seconds; empty: the scene has no animation
};

/// Returns the choice with another device.
Choice withDevice(Choice choice, const std::string& device);

/// Returns whether two choices differ at most in the time.
bool differOnlyInTime(const Choice& a, const Choice& b);

/// Returns whether the picture of the shown side shows the time of a choice, with a sample of each pixel.
bool showsTime(const EngineView& view, const Choice& choice, Mode mode);

/// Returns the mode of the picture: until the device has one, that of the reference is shown.
Mode shownMode(const EngineView& view, Mode mode);

/// Returns the title of the window: the name of the scene and the number of samples of the picture, which is that of
/// both sides where they are compared.
std::string titleOf(const EngineView& view, Mode mode, const std::string& sceneName);

}  // namespace candela::view
