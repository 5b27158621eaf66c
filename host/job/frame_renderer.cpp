// Lends a renderer and its last session to one job after the other.
#include "host/job/frame_renderer.h"

#include <utility>

#include "host/scene/same_scene.h"

namespace candela::job {
namespace {

/// Runs an action. An exception makes `isBroken` true.
template <class Action>
auto watched(bool& isBroken, const Action& action) {
  try {
    return action();
  } catch (...) {
    isBroken = true;
    throw;
  }
}

/// A session that stays when the job ends, unless it has thrown an exception.
class LentSession final : public render::Session {
 public:
  LentSession(render::Session& session, bool isPrepared, bool& isBroken)
      : session_(session), isPrepared_(isPrepared), isBroken_(isBroken) {}

  bool advance(render::SampleRange range, const render::RenderControl& control) override {
    return watched(isBroken_, [&] { return session_.advance(range, control); });
  }
  void restrictTo(const render::PixelMask& mask) override {
    watched(isBroken_, [&] { session_.restrictTo(mask); });
  }
  image::Film film() override {
    return watched(isBroken_, [&] { return session_.film(); });
  }
  void reset(std::uint32_t seed, std::uint32_t sampleCount) override {
    watched(isBroken_, [&] { session_.reset(seed, sampleCount); });
  }
  void setCamera(const scene::Camera& camera) override {
    watched(isBroken_, [&] { session_.setCamera(camera); });
  }
  void setView(const scene::Camera& camera, const render::Extent& size) override {
    watched(isBroken_, [&] { session_.setView(camera, size); });
  }
  void load(const image::Film& film, std::uint32_t first) override {
    watched(isBroken_, [&] { session_.load(film, first); });
  }
  render::RenderStatistics statistics() override {
    return watched(isBroken_, [&] { return ofThisJob(session_.statistics()); });
  }
  render::Salvage salvage() override {
    render::Salvage salvage = session_.salvage();
    salvage.statistics = ofThisJob(std::move(salvage.statistics));
    return salvage;
  }

 private:
  render::RenderStatistics ofThisJob(render::RenderStatistics statistics) const {
    if (!isPrepared_) return statistics;
    for (const char* phase : {"build", "structure", "upload", "pipeline"}) {
      if (statistics.seconds.contains(phase)) statistics.seconds[phase] = 0;
    }
    return statistics;
  }

  render::Session& session_;
  bool isPrepared_;
  bool& isBroken_;
};

render::RenderSettings withoutSeed(render::RenderSettings settings) {
  settings.image.seed = 0;
  return settings;
}

}  // namespace

/// A renderer, and its session for the last job.
class FrameRenderer::Kept {
 public:
  /// `job` is the one that is about to run.
  void begin(const Job& job) { next_ = &job; }

  std::unique_ptr<render::Renderer> lend(const OpenDevice& open) {
    if (isBroken_) {
      session_.reset();
      renderer_.reset();
    }
    isBroken_ = false;
    if (!renderer_) renderer_ = open();
    return std::make_unique<LentRenderer>(*this);
  }

 private:
  class LentRenderer final : public render::Renderer {
   public:
    explicit LentRenderer(Kept& kept) : kept_(kept) {}
    std::unique_ptr<render::Session> prepare(const scene::Scene& scene,
                                             const render::RenderSettings& settings) override {
      return watched(kept_.isBroken_, [&] { return kept_.prepare(scene, settings); });
    }

   private:
    Kept& kept_;
  };

  bool suits(const scene::Scene& scene, const render::RenderSettings& settings) const {
    return session_ && withoutSeed(settings) == withoutSeed(*settings_) && differOnlyInCamera(scene, *scene_);
  }

  std::unique_ptr<render::Session> prepare(const scene::Scene& scene, const render::RenderSettings& settings) {
    const bool isPrepared = suits(scene, settings);
    if (isPrepared) {
      session_->reset(settings.image.seed, settings.image.sampleCount);
      session_->setCamera(*scene.camera);
    } else {
      session_.reset();
      scene_ = next_->sharedScene;
      settings_ = settings;
      session_ = renderer_->prepare(scene, settings);
    }
    return std::make_unique<LentSession>(*session_, isPrepared, isBroken_);
  }

  const Job* next_ = nullptr;
  bool isBroken_ = false;  ///< the renderer or its session has thrown an exception
  std::unique_ptr<render::Renderer> renderer_;
  std::shared_ptr<const scene::Scene> scene_;       ///< of `session_`
  std::optional<render::RenderSettings> settings_;  ///< of `session_`
  std::unique_ptr<render::Session> session_;
};

FrameRenderer::FrameRenderer(OpenDevice open)
    : open_(std::move(open)), device_(std::make_unique<Kept>()), reference_(std::make_unique<Kept>()) {}

FrameRenderer::~FrameRenderer() = default;

JobResult FrameRenderer::run(const Job& job, const JobControl& control, const Log& log) {
  device_->begin(job);
  reference_->begin(job);
  const auto lendDevice = [this] { return device_->lend(open_); };
  const auto lendReference = [this] { return reference_->lend(reference::makeReferenceRenderer); };
  return runJob(job, open_ ? OpenDevice(lendDevice) : OpenDevice(), control, log, lendReference);
}

}  // namespace candela::job
