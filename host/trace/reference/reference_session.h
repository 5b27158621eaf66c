// A scene prepared for the reference tracer, and the film that it renders.
#pragma once
#include <memory>
#include <optional>

#include "host/scene/object_names.h"
#include "host/trace/reference/path.h"
#include "host/trace/reference/rounding/replicas.h"
#include "host/trace/render/film_coverage.h"
#include "host/trace/render/session.h"

namespace candela::reference {

class ReferenceSession final : public render::Session,
                               public render::SampleReplayer,
                               public render::PathRecorder,
                               public render::ReplicaSource {
 public:
  /// The scene must outlive the object.
  ReferenceSession(const scene::Scene& scene, const render::RenderSettings& settings);

  bool advance(render::SampleRange range, const render::RenderControl& control) override;
  void restrictTo(const render::PixelMask& mask) override;
  image::Film film() override { return film_; }
  void reset(std::uint32_t seed, std::uint32_t sampleCount) override;
  void setCamera(const scene::Camera& camera) override;
  void setView(const scene::Camera& camera, const render::Extent& size) override;
  void load(const image::Film& film, std::uint32_t first) override;
  render::RenderStatistics statistics() override;

  render::SampleReplayer* replayer() override { return pathTracer_ != nullptr ? this : nullptr; }
  render::Replay replay(const render::PixelSample& sample) override;

  render::PathRecorder* recorder() override { return settings_.execution.recordPaths ? this : nullptr; }
  render::PathRecords paths() override { return paths_; }

  render::ReplicaSource* replicaSource() override { return replicaTracer_ ? this : nullptr; }
  render::ReplicaRecords replicas() override { return replicas_; }
  render::Replica replica(const render::PixelSample& sample, std::uint32_t index) override {
    return replicaTracer_->trace(sample, index);
  }
  std::vector<render::PathTrace> replayReplicas(const render::PixelSample& sample, std::uint32_t count) override;

 private:
  void prepareReplicas(const scene::Camera& camera);
  void empty();
  void addCounters(const Counters& counters);

  render::RenderSettings settings_;
  std::unique_ptr<PixelTracer> tracer_;
  const PathTracer* pathTracer_ = nullptr;      ///< the tracer, if it traces paths
  std::optional<ReplicaTracer> replicaTracer_;  ///< if the settings request replicas
  std::optional<scene::MatteIds> matteIds_;     ///< of a render with mattes
  image::Film film_;
  render::FilmCoverage coverage_;
  render::PixelMask mask_;
  render::PathRecords paths_;
  render::ReplicaRecords replicas_;
  render::RenderStatistics prepared_;  ///< statistics of the preparation
  render::RenderStatistics statistics_;
  std::uint64_t badSamplesLoaded_ = 0;
};

}  // namespace candela::reference
