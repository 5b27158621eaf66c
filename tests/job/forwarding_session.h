// A session that passes every call on, for tests that change some of them.
#pragma once
#include <memory>
#include <utility>

#include "host/trace/render/session.h"

namespace candela::job {

class ForwardingSession : public render::Session {
 public:
  explicit ForwardingSession(std::unique_ptr<render::Session> inner) : inner_(std::move(inner)) {}

  bool advance(render::SampleRange range, const render::RenderControl& control) override {
    return inner_->advance(range, control);
  }
  void restrictTo(const render::PixelMask& mask) override { inner_->restrictTo(mask); }
  image::Film film() override { return inner_->film(); }
  void reset(std::uint32_t seed, std::uint32_t sampleCount) override { inner_->reset(seed, sampleCount); }
  void setCamera(const scene::Camera& camera) override { inner_->setCamera(camera); }
  void setView(const scene::Camera& camera, const render::Extent& size) override { inner_->setView(camera, size); }
  void load(const image::Film& film, std::uint32_t first) override { inner_->load(film, first); }
  render::RenderStatistics statistics() override { return inner_->statistics(); }

 private:
  std::unique_ptr<render::Session> inner_;
};

}  // namespace candela::job
