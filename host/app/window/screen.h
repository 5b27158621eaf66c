// The window, and how its frames are drawn.
#pragma once
#include <functional>
#include <memory>
#include <string>

#include "host/app/window/device_picture.h"
#include "host/app/window/gui_painter.h"
#include "host/app/window/key_map.h"
#include "host/app/window/picture_painter.h"
#include "host/app/window/presenter.h"
#include "host/app/window/viewer.h"
#include "host/app/window/window.h"

namespace candela::window {

/// The context of Dear ImGui, of which there is one at a time.
class GuiContext {
 public:
  GuiContext();
  ~GuiContext();
  GuiContext(const GuiContext&) = delete;
  GuiContext& operator=(const GuiContext&) = delete;
};

/// The window on the display, with everything on the device that draws into it.
class Screen {
 public:
  /// Opens the device and the window. Throws NoDeviceError where the device or the display cannot present.
  Screen(const ViewerOptions& options, const render::Extent& size);
  /// Waits for the last frame, since the device may still read its inputs.
  ~Screen();
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;

  DesktopWindow& window() { return window_; }
  GuiInput& guiInput() { return guiInput_; }
  DevicePicture& devicePicture() { return *devicePicture_; }
  const DevicePicture& devicePicture() const { return *devicePicture_; }
  render::Extent size() const { return presenter_->size(); }

  /// Follows the window's size and changes of its surface. Returns whether the frames have another size than before.
  bool resize();
  /// Sets the title of the window, if it is another one.
  void setTitle(const std::string& title);
  /// Draws a frame: the picture, and over it the panels that `panels` draws with Dear ImGui; its argument is the values
  /// below the pointer. Returns whether the frame is shown. A window that is minimised shows none; otherwise the frame
  /// is to be drawn again.
  bool draw(const PaintedView& view, const std::function<void(const gpu::PointedValues&)>& panels);

 private:
  void beginPanels();

  const Glfw& glfw_;
  vulkan::Device device_;
  DesktopWindow window_;
  std::unique_ptr<Presenter> presenter_;
  GuiContext gui_;
  GuiInput guiInput_;
  std::unique_ptr<PicturePainter> picturePainter_;
  std::unique_ptr<GuiPainter> guiPainter_;
  std::unique_ptr<DevicePicture> devicePicture_;
  std::string title_;
  double lastTime_;  ///< of the last frame, by monotonicSeconds()
};

}  // namespace candela::window
