// Opens the window, and draws its frames.
#include "host/app/window/screen.h"

#include <imgui.h>

#include <algorithm>
#include <vector>

#include "host/base/errors.h"
#include "host/base/progress.h"
#include "host/trace/vulkan/unfinished_work.h"

namespace candela::window {
namespace {

std::vector<std::string> windowExtensions(const Glfw& glfw) {
  std::uint32_t count = 0;
  const char** const names = glfw.GetRequiredInstanceExtensions(&count);
  if (names == nullptr)
    throw NoDeviceError(
        "candela view needs a Vulkan driver that can present to this display; `candela doctor` examines the drivers");
  return {names, names + count};
}

vulkan::Device openPresenting(const ViewerOptions& options, const Glfw& glfw) {
  vulkan::Device device = options.openDevice(windowExtensions(glfw));
  if (!device.canPresent()) throw NoDeviceError(device.info().name + " cannot draw windows; choose another device");
  return device;
}

}  // namespace

GuiContext::GuiContext() {
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;
  ImGui::StyleColorsDark();
  prepareKeys();
}

GuiContext::~GuiContext() { ImGui::DestroyContext(); }

Screen::Screen(const ViewerOptions& options, const render::Extent& size)
    : glfw_(openGlfw()),
      device_(openPresenting(options, glfw_)),
      window_(glfw_, size, "candela: " + options.scene.filename().string()),
      presenter_(std::make_unique<Presenter>(device_, window_.surface(device_.impl()->instance.handle),
                                             window_.framebuffer())),
      picturePainter_(std::make_unique<PicturePainter>(device_)),
      guiPainter_(std::make_unique<GuiPainter>(device_, presenter_->renderPass())),
      devicePicture_(std::make_unique<DevicePicture>(device_)),
      lastTime_(monotonicSeconds()) {}

Screen::~Screen() {
  try {
    presenter_->waitForLastFrame();
  } catch (const Error&) {  // the device is lost, and uses nothing any more, or it hangs
  }
  if (!vulkan::hasUnfinishedWork()) return;
  // A device that hangs may be using these objects until the process ends.
  static_cast<void>(devicePicture_.release());
  static_cast<void>(guiPainter_.release());
  static_cast<void>(picturePainter_.release());
  static_cast<void>(presenter_.release());
}

bool Screen::resize() {
  if (!presenter_->mustResize(window_.framebuffer())) return false;
  const render::Extent before = presenter_->size();
  presenter_->resize(window_.framebuffer());
  return presenter_->size() != before;
}

void Screen::setTitle(const std::string& title) {
  if (title != title_) window_.setTitle(title_ = title);
}

void Screen::beginPanels() {
  const render::Extent size = presenter_->size();
  const double now = monotonicSeconds();
  ImGui::GetIO().DisplaySize = ImVec2(static_cast<float>(size.width), static_cast<float>(size.height));
  ImGui::GetIO().DeltaTime = static_cast<float>(std::max(1e-4, now - lastTime_));
  lastTime_ = now;
  ImGui::NewFrame();
}

bool Screen::draw(const PaintedView& view, const std::function<void(const gpu::PointedValues&)>& panels) {
  presenter_->waitForLastFrame();
  const render::Extent size = presenter_->size();
  if (size.width == 0 || size.height == 0) return false;
  picturePainter_->prepare(size, view);
  beginPanels();
  panels(picturePainter_->pointed());
  ImGui::Render();
  guiInput_.finishFrame();
  return presenter_->draw([&](const Presenter::Frame& frame) {
    vulkan::CommandRecorder recorder(frame.recorder);
    picturePainter_->record(recorder, view, presenter_->isBlueFirst());
    frame.recorder.makeVisibleToNext();
    copyToImage(frame, picturePainter_->pixels());
    guiPainter_->record(frame, presenter_->renderPass(), *ImGui::GetDrawData());
  });
}

}  // namespace candela::window
