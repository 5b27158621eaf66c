// The widgets.
#include "host/app/window/panels.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace candela::window {
namespace {

constexpr float kMaxPanelWidth = 340;  // beside the picture
constexpr std::array kModes{"device", "reference", "split", "difference"};
constexpr std::array kToneMaps{"none", "srgb", "aces", "aces-hill", "agx", "neutral", "depth", "heat"};
constexpr std::array kIntegrators{"path", "whitted", "ao", "normal", "albedo", "depth", "id", "cost"};
constexpr const char* kKeyHelp =
    "drag: orbit   Shift or middle: pan   right: look\n"
    "wheel: distance   Ctrl+wheel, Ctrl+drag: magnify\n"
    "W A S D Q E: fly, with Shift faster\n"
    "1 2 3 4: device, reference, split, difference\n"
    "V, Shift+V: next, previous layer\n"
    "[ ]: exposure   T: tone map   , .: gain of difference\n"
    "click: path of a pixel   N: pixel that differs most\n"
    "R: first camera   C: copy camera   L: reload\n"
    "P: save   I: integrator   space: pause\n"
    "K: play or pause the animation   H: hide panels   Esc: quit";

void text(const std::string& line) { ImGui::TextUnformatted(line.c_str()); }

// A list of words; returns whether another one was chosen.
template <std::size_t N>
bool combo(const char* label, const std::array<const char*, N>& words, int& index, std::size_t count = N) {
  return ImGui::Combo(label, &index, words.data(), static_cast<int>(count));
}

std::string sideText(const char* name, const view::SideView& side, const view::EngineView& engine) {
  if (!side.hasSession) return fmt::format("{}: none", name);
  if (side.scale == 0) return fmt::format("{}: -", name);
  if (side.scale > 1) return fmt::format("{}: 1/{} resolution", name, side.scale);
  return fmt::format("{}: {} of {} samples, {:.1f} s", name, side.samples, engine.sampleCount, side.seconds);
}

// The values of a side at a pixel, and the number of samples. `onDevice` are those of a picture that is on the device.
std::string valueText(const char* name, const view::EngineView& engine, const view::SideView& side,
                      const glm::uvec2& pixel, const glm::vec4& onDevice) {
  const glm::vec4 value = side.picture ? side.picture->at(pixel.x, pixel.y) : onDevice;
  if (value.w == 0) return fmt::format("{}: -", name);
  const std::string known = value.w > 0 ? fmt::format("{:.0f}", value.w) : fmt::format("1/{:.0f}", -value.w);
  const std::size_t index = std::size_t{pixel.y} * engine.size.width + pixel.x;
  const bool hasIds = engine.matteNames && side.picture && index < side.picture->ids.size();
  const std::string values = hasIds ? view::matteText(side.picture->ids[index], *engine.matteNames)
                                    : view::valueText(engine.choice.layer, glm::vec3(value));
  return fmt::format("{}: {} ({})", name, values, known);
}

// Returns the name of the device in use, or that it is being prepared.
std::string deviceLabel(const view::EngineView& engine) {
  if (engine.choice.usesReference()) return "cpu: the reference alone";
  return engine.deviceName.empty() ? "preparing ..." : engine.deviceName;
}

}  // namespace

Panels::Panels(const std::string& file) {
  std::copy_n(file.begin(), std::min(file.size(), file_.size() - 1), file_.begin());
}

void Panels::drawRender(const PanelInput& input, PanelChoice& choice) {
  const view::EngineView& engine = input.engine;
  if (ImGui::BeginCombo("device", deviceLabel(engine).c_str())) {
    for (std::size_t i = 0; i <= input.devices.size(); ++i) {
      const bool isReference = i == input.devices.size();
      const std::string selector = isReference ? render::kReferenceDevice : std::to_string(i);
      const std::string label = isReference ? "cpu: the reference alone" : fmt::format("{}: {}", i, input.devices[i]);
      if (ImGui::Selectable(label.c_str(), selector == engine.choice.device))
        choice.choice = withDevice(engine.choice, selector);
    }
    ImGui::EndCombo();
  }
  int integrator = static_cast<int>(engine.choice.integrator);
  if (combo("integrator", kIntegrators, integrator)) {
    choice.choice = withIntegrator(engine.choice, static_cast<render::Integrator>(integrator));
  }
  text(sideText("device", engine.sides[0], engine));
  text(sideText("reference", engine.sides[1], engine));
  if (engine.isPreparing) text("the driver is compiling; preview by the reference");
  text(fmt::format("{} pixels{}", extentText(engine.size), input.presentsFromDevice ? ", shown without readback" : ""));
  text(fmt::format("input answered in {:.0f} ms", 1e3 * input.response));
}

void Panels::drawLayer(const PanelInput& input, PanelChoice& choice) {
  const view::Choice& current = input.engine.choice;
  const auto item = [&](view::ShownLayer layer) {
    if (ImGui::Selectable(std::string(view::shownName(layer)).c_str(), layer == current.layer))
      choice.choice = withLayer(current, layer);
  };
  if (ImGui::BeginCombo("layer", std::string(view::shownName(current.layer)).c_str())) {
    item({});
    for (const image::Layer layer : view::shownLayers()) item(layer);
    ImGui::EndCombo();
  }
}

void Panels::drawView(view::ViewState& state, const PanelInput& input, PanelChoice& choice) {
  int mode = static_cast<int>(state.mode);
  if (combo("show", kModes, mode)) choice.mode = static_cast<view::Mode>(mode);
  if (input.shownMode != state.mode) text("the reference, until the device is ready");
  drawLayer(input, choice);
  const view::ShownLayer layer = input.engine.choice.layer;
  if (!view::isLight(layer))
    text(view::keyText(layer, state.display, input.engine.layerRange, input.engine.sampleCount));
  ImGui::SliderFloat("exposure", &state.display.exposure, -10, 10, "%.2f stops");
  int toneMap = static_cast<int>(state.display.toneMap);
  if (combo("tone map", kToneMaps, toneMap)) state.display.toneMap = static_cast<image::ToneMap>(toneMap);
  if (state.mode == view::Mode::split) {
    float divider = static_cast<float>(state.divider);
    if (ImGui::SliderFloat("divider", &divider, 0, 1, "%.3f")) state.divider = std::clamp(divider, 0.0f, 1.0f);
  }
}

void Panels::drawTime(const PanelInput& input, PanelChoice& choice) {
  if (!input.engine.animationEnd || *input.engine.animationEnd <= 0) return;
  const auto end = static_cast<float>(*input.engine.animationEnd);
  auto time = static_cast<float>(input.engine.choice.time.value_or(0));
  if (ImGui::SliderFloat("time", &time, 0, end, input.engine.choice.time ? "%.3f s" : "at rest")) {
    choice.time = std::clamp(time, 0.0f, end);
  }
  choice.playOrPause = ImGui::Button(input.isPlaying ? "pause animation" : "play animation");
}

void Panels::drawDifference(view::ViewState& state, const PanelInput& input, PanelChoice& choice) {
  ImGui::SliderInt("gain", &state.differenceStops, 0, view::ViewState::kMaxGainStops, "2^%d");
  ImGui::TextColored(ImVec4(1, 0.55f, 0.1f, 1), "device brighter");
  ImGui::SameLine();
  ImGui::TextColored(ImVec4(0.3f, 0.6f, 1, 1), "reference brighter");
  if (!input.engine.difference) {
    text("no equal numbers of samples yet");
    return;
  }
  const view::PictureDifference& difference = *input.engine.difference;
  const double mean = difference.meanB == 0 ? 0 : (difference.meanA - difference.meanB) / difference.meanB;
  if (view::isLight(input.engine.choice.layer))
    text(fmt::format("mean: device {:.6g}, {:+.2e} relative", difference.meanA, mean));
  text(fmt::format("{} of {} pixels differ by more than 1e-4", difference.unequal, difference.pixels));
  text(fmt::format("most: {:+.3g} at {},{}", difference.worstDifference, difference.worst.x, difference.worst.y));
  ImGui::SameLine();
  choice.inspectWorst = ImGui::SmallButton("explain");
}

void Panels::drawPixel(view::ViewState& state, const PanelInput& input, PanelChoice& choice) {
  if (const auto pixel = pixelAt(state, input.engine.size, state.pointer)) {
    text(fmt::format("pixel {},{}", pixel->x, pixel->y));
    text(valueText("device", input.engine, input.engine.sides[0], *pixel, input.pointed.device));
    text(valueText("reference", input.engine, input.engine.sides[1], *pixel, input.pointed.reference));
  } else {
    for (const char* line : {"pixel -", "device: -", "reference: -"}) text(line);  // as many lines as above
  }
  drawSave(input, choice);
}

void Panels::drawSave(const PanelInput& input, PanelChoice& choice) {
  ImGui::InputText("file", file_.data(), file_.size());
  if (ImGui::Button("save")) choice.file = file();
  ImGui::SameLine();
  choice.copyCamera = ImGui::Button("copy camera");
  ImGui::SameLine();
  choice.reload = ImGui::Button("reload");
  if (input.engine.message.empty()) return;
  ImGui::PushTextWrapPos(0);
  ImGui::TextColored(input.engine.isError ? ImVec4(1, 0.4f, 0.4f, 1) : ImVec4(0.6f, 1, 0.6f, 1), "%s",
                     input.engine.message.c_str());
  ImGui::PopTextWrapPos();
}

void Panels::drawPath(view::ViewState& state, const PanelInput& input, PanelChoice& choice) {
  constexpr float kLeft = 352, kBorder = 8;
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  const float height = std::max(window.y / 2, 180.0f);
  ImGui::SetNextWindowPos(ImVec2(kLeft, window.y - height - kBorder), ImGuiCond_FirstUseEver);
  ImGui::SetNextWindowSize(ImVec2(std::max(window.x - kLeft - kBorder, 300.0f), height), ImGuiCond_FirstUseEver);
  bool isOpen = true;
  if (ImGui::Begin("path", &isOpen, ImGuiWindowFlags_HorizontalScrollbar)) {
    int sample = static_cast<int>(state.inspectedSample);
    if (ImGui::InputInt("sample", &sample)) {
      const auto last = static_cast<int>(input.engine.sampleCount - 1);
      state.inspectedSample = static_cast<std::uint32_t>(std::clamp(sample, 0, last));
      choice.inspect = true;
    }
    text(input.engine.explanation.empty() ? "..." : input.engine.explanation);
  }
  ImGui::End();
  if (!isOpen) state.inspected.reset();
}

PanelChoice Panels::draw(view::ViewState& state, const PanelInput& input) {
  PanelChoice choice;
  if (!state.arePanelsShown) return choice;
  ImGui::SetNextWindowPos(ImVec2(8, 8), ImGuiCond_FirstUseEver);
  ImGui::SetNextWindowBgAlpha(0.8f);
  ImGui::SetNextWindowSizeConstraints(ImVec2(0, 0), ImVec2(kMaxPanelWidth, ImGui::GetIO().DisplaySize.y));
  if (ImGui::Begin("candela", nullptr, ImGuiWindowFlags_AlwaysAutoResize)) {
    ImGui::PushItemWidth(230);
    drawRender(input, choice);
    ImGui::Separator();
    drawView(state, input, choice);
    drawTime(input, choice);
    if (comparesSides(state.mode)) drawDifference(state, input, choice);
    ImGui::Separator();
    drawPixel(state, input, choice);
    if (ImGui::CollapsingHeader("keys")) text(kKeyHelp);
    ImGui::PopItemWidth();
  }
  ImGui::End();
  if (state.inspected) drawPath(state, input, choice);
  return choice;
}

void drawDivider(const view::ViewState& state, const PanelInput& input) {
  if (input.shownMode != view::Mode::split) return;
  constexpr ImU32 kWhite = IM_COL32(255, 255, 255, 255), kShade = IM_COL32(0, 0, 0, 160);
  const double x = state.placement.origin.x + state.placement.zoom * state.divider * input.engine.size.width;
  const double bottom = state.placement.origin.y + state.placement.zoom * input.engine.size.height;
  const auto label = [&](const char* words, float left) {
    const ImVec2 size = ImGui::CalcTextSize(words);
    const ImVec2 at(left < 0 ? static_cast<float>(x) - 8 - size.x : static_cast<float>(x) + 8,
                    static_cast<float>(bottom) - 22);
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.AddRectFilled(ImVec2(at.x - 4, at.y - 2), ImVec2(at.x + size.x + 4, at.y + size.y + 2), kShade, 3);
    list.AddText(at, kWhite, words);
  };
  label("device", -1);
  label("reference", 1);
}

}  // namespace candela::window
