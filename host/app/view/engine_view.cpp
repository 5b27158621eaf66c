// Describes the state of the engine in words.
#include "host/app/view/engine_view.h"

#include <fmt/format.h>

#include <algorithm>

namespace candela::view {

Choice withLayer(Choice choice, ShownLayer layer) {
  choice.layer = layer;
  if (layer) choice.integrator = render::Integrator::path;
  return choice;
}

Choice withIntegrator(Choice choice, render::Integrator integrator) {
  choice.integrator = integrator;
  if (integrator != render::Integrator::path) choice.layer.reset();
  return choice;
}

Choice withDevice(Choice choice, const std::string& device) {
  choice.device = device;
  return choice;
}

bool differOnlyInTime(const Choice& a, const Choice& b) {
  Choice other = b;
  other.time = a.time;
  return a == other;
}

bool showsTime(const EngineView& view, const Choice& choice, Mode mode) {
  const bool showsReference = shownMode(view, mode) == Mode::reference;
  const SideView& side = view.sides[showsReference ? 1 : 0];
  return view.choice.time == choice.time && side.scale == 1 && side.samples > 0;
}

Mode shownMode(const EngineView& view, Mode mode) {
  const bool hasReferenceAlone = view.sides[0].scale == 0 && view.sides[1].scale > 0;
  return hasReferenceAlone ? Mode::reference : mode;
}

std::string titleOf(const EngineView& view, Mode mode, const std::string& sceneName) {
  if (view.isPreparing) return sceneName + ": preview - candela";
  const SideView& device = view.sides[0];
  const SideView& reference = view.sides[1];
  std::uint32_t samples = shownMode(view, mode) == Mode::reference ? reference.samples : device.samples;
  if (comparesSides(mode)) samples = std::min(samples, reference.samples);
  return fmt::format("{}: {} of {} samples - candela", sceneName, samples, view.sampleCount);
}

}  // namespace candela::view
