// The worker of a viewer. Members that belong to the window's thread post requests; the loop of the engine's thread
// takes them, decides on the next step, runs it and shows its result.
#include "host/app/view/engine.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "host/app/view/camera_text.h"
#include "host/base/errors.h"
#include "host/base/progress.h"
#include "host/image/false_colour.h"
#include "host/judge/explain/explanation.h"
#include "host/scene/object_names.h"

namespace candela::view {
namespace {

constexpr double kFirstSeconds = 0.05;   // for which requests do not interrupt the first picture of a view
constexpr double kPartialSeconds = 0.1;  // between two pictures of an unfinished step in full resolution
constexpr std::uint32_t kSearchedSamples = 64;

std::shared_ptr<const std::map<std::uint32_t, std::string>> matteNamesOf(const scene::Scene& scene, ShownLayer layer) {
  const auto kind = layer ? matteKindOf(*layer) : std::nullopt;
  if (!kind) return nullptr;
  return std::make_shared<const std::map<std::uint32_t, std::string>>(scene::matteNamesById(scene, *kind));
}

// Returns the index of the sample among the first `count` of a pixel on which the two sides agree least. Its radiance
// is replayed on both. At most kSearchedSamples are searched.
std::uint32_t worstSample(render::SampleReplayer& device, render::SampleReplayer& reference, render::PixelSample sample,
                          std::uint32_t count) {
  double worst = -1;
  std::uint32_t found = 0;
  for (sample.index = 0; sample.index < std::clamp(count, 1u, kSearchedSamples); ++sample.index) {
    const glm::dvec3 radiance = device.replay(sample).path.radiance;
    const double apart = glm::distance(radiance, reference.replay(sample).path.radiance);
    if (apart <= worst) continue;
    worst = apart;
    found = sample.index;
  }
  return found;
}

}  // namespace

Engine::Engine(EngineHooks hooks, Choice choice, Mode mode)
    : hooks_(std::move(hooks)), choice_(std::move(choice)), mode_(mode), sessions_(hooks_.load(choice_, false)) {
  adopt(std::move(sessions_), false);  // without a scene before it, so that the camera is the scene's
  startDevice();
  publish();
  thread_ = std::thread([this] { loop(); });
}

Engine::~Engine() {
  inbox_.end();
  thread_.join();
}

EngineView Engine::view() const {
  const std::scoped_lock lock(mutex_);
  return published_;
}

std::uint64_t Engine::setCamera(const scene::Camera& camera) {
  std::uint64_t serial = 0;
  inbox_.post([&](Requests& requests) {
    requests.camera = camera;
    serial = ++requests.viewSerial;
  });
  return serial;
}

void Engine::setMode(Mode mode, bool isPaused) {
  inbox_.post([&](Requests& requests) { requests.mode = {mode, isPaused}; });
}

void Engine::setChoice(const Choice& choice) {
  inbox_.post([&](Requests& requests) { requests.load = choice; });
}

void Engine::reload() {
  const Choice current = view().choice;
  inbox_.post([&](Requests& requests) {
    if (!requests.load) requests.load = current;
    requests.reads = true;
  });
}

void Engine::save(const std::filesystem::path& file, const image::DisplayTransform& display) {
  inbox_.post([&](Requests& requests) { requests.save = {file, display}; });
}

void Engine::explain(const render::PixelSample& sample, bool searches) {
  inbox_.post([&](Requests& requests) {
    requests.sample = sample;
    requests.searches = searches;
  });
}

void Engine::loop() {
  while (!inbox_.isEnded()) {
    if (!guarded([this] { iterate(); })) hasFailed_ = true;  // otherwise it would fail repeatedly
    if (hasFailed_) pendingSave_.reset();
  }
}

void Engine::iterate() {
  adoptDevice();
  const std::optional<Step> step = nextStep();
  if (const std::optional<Requests> requests = inbox_.take(!step)) {
    apply(*requests);
  } else if (step) {
    run(*step);
  }
}

// A pause lets a new view have its first sample, so that the camera can be moved.
std::optional<Step> Engine::nextStep() const {
  const std::optional<Step> step = hasFailed_ ? std::nullopt : schedule_->next();
  return isPaused_ && step && step->sampleEnd > 1 ? std::nullopt : step;
}

void Engine::apply(const Requests& requests) {
  hasFailed_ = false;
  if (requests.load) guarded([&] { load(*requests.load, requests.reads); });
  if (requests.mode) setMode(*requests.mode);
  if (requests.camera) {
    camera_ = *requests.camera;
    next_.viewSerial = requests.viewSerial;
    restart();
  }
  if (requests.save) startSave(*requests.save);
  if (requests.sample) guarded([&] { explainNow(*requests.sample, requests.searches); });
}

// At another time of the animation, the device is prepared at once: its pipelines are compiled already. The picture
// stays until the next one replaces it.
void Engine::load(const Choice& choice, bool reads) {
  const bool isOtherTime = !reads && differOnlyInTime(choice, choice_);
  const bool hasDevice = sessions_.device && !coming_.isUnderWay();
  Sessions sessions = hooks_.load(choice, reads);
  if (isOtherTime && hasDevice) hooks_.addDevice(choice, sessions);
  choice_ = choice;
  adopt(std::move(sessions), isOtherTime);
  if (!sessions_.device) startDevice();
  say("", false);
}

void Engine::adopt(Sessions sessions, bool keepsPictures) {
  const bool keepsCamera = sessions_.scene &&
                           cameraText(*sessions_.scene->camera) == cameraText(*sessions.scene->camera);
  sessions_ = std::move(sessions);
  if (!keepsCamera) camera_ = *sessions_.scene->camera;
  schedule_.emplace(sessions_.settings.image.size, sessions_.settings.image.sampleCount);
  next_.scene = sessions_.scene;
  next_.animationEnd = sessions_.animationEnd;
  next_.choice = choice_;
  next_.size = sessions_.settings.image.size;
  next_.sampleCount = sessions_.settings.image.sampleCount;
  next_.explanation.clear();
  next_.layerRange = {};
  next_.matteNames = matteNamesOf(*next_.scene, choice_.layer);
  if (!keepsPictures) {
    for (auto& picture : pictures_) picture = std::make_shared<Picture>(next_.size);
    next_.sides = {};
  }
  for (SideView& side : next_.sides) side.samples = 0;
  want();
  restart();
}

void Engine::startDevice() {
  coming_.abandon();
  next_.isPreparing = !choice_.usesReference();
  if (!next_.isPreparing) return;
  coming_.start([add = hooks_.addDevice, choice = choice_, scene = sessions_.scene, settings = sessions_.settings] {
    Sessions made{scene, settings};
    add(choice, made);
    return made;
  });
}

void Engine::adoptDevice() {
  if (!coming_.isReady()) return;
  next_.isPreparing = false;
  Sessions made = coming_.take();
  sessions_.device = std::move(made.device);
  next_.deviceName = made.deviceName;
  preparedScale_[indexOf(Side::device)] = 0;
  want();
  if (comparesSides(mode_)) restart();
}

void Engine::setMode(const NewMode& mode) {
  const bool startsComparing = comparesSides(mode.mode) && !comparesSides(mode_);
  mode_ = mode.mode;
  isPaused_ = mode.isPaused;
  want();
  if (startsComparing && !schedule_->isLevel()) restart();
  publish();
}

// Without a device, the reference is shown in all modes.
void Engine::want() {
  const bool hasDevice = sessions_.device != nullptr;
  schedule_->setWanted(Side::device, hasDevice && wants(mode_, Side::device));
  schedule_->setWanted(Side::reference, !hasDevice || wants(mode_, Side::reference));
  next_.sides[indexOf(Side::device)].hasSession = hasDevice;
  next_.sides[indexOf(Side::reference)].hasSession = true;
}

// A side that continues keeps its picture until its next step replaces it. A side that does not loses it, since it
// would show an earlier view.
void Engine::restart() {
  schedule_->restart();
  preparedScale_ = {};
  for (const Side side : {Side::device, Side::reference}) {
    SideView& view = next_.sides[indexOf(side)];
    view.seconds = 0;
    if (schedule_->isWanted(side)) continue;
    pictures_[indexOf(side)] = std::make_shared<Picture>(next_.size);
    const bool hasSession = view.hasSession;
    view = {};
    view.hasSession = hasSession;
  }
  next_.difference.reset();
}

void Engine::run(const Step& step) {
  const double start = monotonicSeconds();
  render::Session& session = *sessions_.session(step.side);
  std::uint32_t& prepared = preparedScale_[indexOf(step.side)];
  if (prepared != step.scale) {
    session.setView(camera_, scaled(sessions_.settings.image.size, step.scale));
    prepared = step.scale;
  }
  if (trace(step, start)) finish(step, monotonicSeconds() - start);
}

// Returns false if a request came. Unfinished pictures are shown unless they are compared.
bool Engine::trace(const Step& step, double start) {
  render::Session& session = *sessions_.session(step.side);
  const bool showsPartial = step.scale == 1 && (!comparesSides(mode_) || step.sampleEnd == 1);
  const bool isFirst = schedule_->scale(step.side) == 0;
  double shown = start;
  std::atomic<bool> stop{false};
  const auto watch = [&](double, std::uint64_t) {
    const double now = monotonicSeconds();
    if (inbox_.isFull() && (!isFirst || inbox_.isEnded() || now - start > kFirstSeconds)) stop = true;
    if (showsPartial && now - shown > kPartialSeconds) stop = true;
  };
  while (!session.advance({0, step.sampleEnd}, {&stop, watch})) {
    if (inbox_.isFull()) return false;
    stop = false;
    show(step.side);
    publish();
    shown = monotonicSeconds();
  }
  return true;
}

void Engine::finish(const Step& step, double seconds) {
  schedule_->finish(step, seconds);
  SideView& side = next_.sides[indexOf(step.side)];
  side.seconds += seconds;
  if (!comparesSides(mode_) || step.scale > 1 || step.sampleEnd == 1) {
    show(step.side);
  } else if (schedule_->isLevel()) {
    show(Side::device);
    show(Side::reference);
  }
  if (schedule_->isLevel()) compareSides();
  measureRanges();
  publish();
  finishSave();
}

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

void Engine::startSave(const SaveRequest& request) {
  pendingSave_ = request;
  finishSave();
  if (pendingSave_) say(request.file.string() + ": is written when each pixel has a sample", false);
}

// Until all pixels have a sample, the session's film is that of an earlier camera or of a preview.
void Engine::finishSave() {
  const Side side = mode_ == Mode::reference || !sessions_.device ? Side::reference : Side::device;
  if (!pendingSave_ || schedule_->scale(side) != 1) return;
  const SaveRequest request = *std::exchange(pendingSave_, std::nullopt);
  guarded([&] { saveNow(side, request); });
}

void Engine::saveNow(Side side, const SaveRequest& request) {
  render::Session& session = *sessions_.session(side);
  hooks_.save(request.file, sessions_, camera_, session.film(), session.statistics(), choice_, request.display);
  const std::uint32_t samples = schedule_->samples(side);
  say(fmt::format("{}: {} {} per pixel", request.file.string(), samples, samples == 1 ? "sample" : "samples"), false);
}

void Engine::explainNow(render::PixelSample sample, bool searches) {
  explain::requirePaths(sessions_.settings.image.integrator);
  if (!sessions_.device) throw UsageError("explaining a path needs a device, and none is ready yet");
  for (const Side side : {Side::device, Side::reference}) {
    if (preparedScale_[indexOf(side)] == 1) continue;
    sessions_.session(side)->setView(camera_, sessions_.settings.image.size);
    preparedScale_[indexOf(side)] = 0;
  }
  render::SampleReplayer& device = *sessions_.device->replayer();
  render::SampleReplayer& reference = *sessions_.reference->replayer();
  if (searches) sample.index = worstSample(device, reference, sample, schedule_->samples(Side::device));
  next_.explained = sample;
  next_.explanation = toText(explain::explainReplays(*sessions_.scene, sessions_.settings, sample,
                                                     device.replay(sample), reference.replay(sample)));
  publish();
}

void Engine::publish() {
  {
    const std::scoped_lock lock(mutex_);
    ++next_.serial;
    published_ = next_;
  }
  hooks_.wake();
}

void Engine::say(const std::string& message, bool isError) {
  next_.message = message;
  next_.isError = isError;
  publish();
}

// A device that fails is not used any more. Returns false for any other error.
bool Engine::guarded(const std::function<void()>& work) {
  try {
    work();
    return true;
  } catch (const DeviceLostError& error) {
    dropDevice(error.what());
    return true;
  } catch (const OutOfMemoryError& error) {
    dropDevice(error.what());
    return true;
  } catch (const std::exception& error) {
    next_.isPreparing = coming_.isUnderWay();
    say(error.what(), true);
    return false;
  }
}

void Engine::dropDevice(const std::string& reason) {
  hasFailed_ = sessions_.device == nullptr;  // it was the reference that failed
  sessions_.device.reset();
  want();
  next_.isPreparing = coming_.isUnderWay();
  say(reason + "; the reference continues", true);
}

}  // namespace candela::view
