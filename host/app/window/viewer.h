// The viewer's window and its loop.
#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "host/app/view/engine.h"
#include "host/app/view/view_state.h"
#include "host/trace/vulkan/device.h"

namespace candela::window {

struct ViewerOptions {
  view::EngineHooks hooks;  ///< without showOnDevice and wake, which are the window's
  view::Choice choice;
  std::vector<std::string> devices;  ///< names of the Vulkan devices, in the order of their indices
  std::filesystem::path scene;
  render::Extent size;  ///< of the picture, from which the window's follows
  view::Mode mode = view::Mode::device;
  image::DisplayTransform display;
  /// Opens the device that presents. `windowExtensions` are vulkan::DeviceOptions::windowExtensions.
  std::function<vulkan::Device(const std::vector<std::string>& windowExtensions)> openDevice;
  double start = 0;  ///< time of monotonicSeconds() at which the program started
};

/// The measurements of a viewer, in seconds.
struct ViewerReport {
  double firstPicture = 0;        ///< from the start to the first frame with a picture; 0: there was none
  std::vector<double> responses;  ///< from each event that moved the camera to the frame that shows the new view
  std::uint64_t frames = 0;
  view::EngineView last;            ///< when the window was closed
  bool presentsFromDevice = false;  ///< the last picture of the device was shown without reading it
};

/// Shows the window until it is closed, or SIGINT or SIGTERM arrives. Throws NoDeviceError where there is no display,
/// or where the program was built without the libraries; Engine's constructor may throw, too.
ViewerReport runViewer(const ViewerOptions& options);

}  // namespace candela::window
