// Converts films to the pictures that are shown.
#include <algorithm>

#include "host/image/false_colour.h"
#include "host/view/engine.h"

namespace candela::view {

// Copies the film of a side to its picture. Layers are converted on the host.
void Engine::show(Side side) {
  SideView& view = next_.sides[indexOf(side)];
  render::Session& session = *sessions_.session(side);
  view.isOnDevice = side == Side::device && !choice_.layer && hooks_.showOnDevice(session, next_.size);
  view.scale = std::max(schedule_->scale(side), 1u);
  view.samples = schedule_->samples(side);
  if (view.isOnDevice) {
    view.picture = nullptr;
    return;
  }
  auto picture = std::make_shared<Picture>(*pictures_[indexOf(side)]);
  picture->isLight = isLight(choice_.layer);
  if (choice_.layer) {
    showLayer(session.film(), *choice_.layer, *picture);
  } else {
    view::show(session.film(), *picture);
  }
  pictures_[indexOf(side)] = picture;
  view.picture = std::move(picture);
}

// Measures the values to which the colours of the shown side are fitted.
void Engine::measureRanges() {
  const Side side = wants(mode_, Side::device) && sessions_.device ? Side::device : Side::reference;
  if (choice_.layer == image::Layer::depth || choice_.layer == image::Layer::position) {
    next_.layerRange = rangeOf(*pictures_[indexOf(side)]);
    return;
  }
  const bool isDepth = choice_.integrator == render::Integrator::depth;
  if (!isDepth && choice_.integrator != render::Integrator::cost) return;
  const image::ToneMap toneMap = isDepth ? image::ToneMap::depth : image::ToneMap::heat;
  next_.falseColourScale = falseColourScale(toImage(sessions_.session(side)->film()), toneMap);
}

// Both sides have been shown with the same number of samples. A picture that is on the device is read back.
void Engine::compareSides() {
  std::shared_ptr<const Picture> device = next_.sides[indexOf(Side::device)].picture;
  if (!device) {
    auto picture = std::make_shared<Picture>(next_.size);
    view::show(sessions_.device->film(), *picture);
    device = std::move(picture);
  }
  next_.difference = compare(*device, *pictures_[indexOf(Side::reference)]);
}

}  // namespace candela::view
