// A renderer for tests whose sessions render everything at once, by a function.
#pragma once
#include <memory>
#include <stdexcept>

#include "host/trace/render/renderer.h"

namespace candela::test {

/// The derived class defines the result of a whole render; its sessions cannot continue films.
class OneShotRenderer : public render::Renderer {
 public:
  bool onGpu = false;  ///< what its sessions state about their device

  virtual render::RenderResult renderOnce(const scene::Scene& scene, const render::RenderSettings& settings,
                                          const render::RenderControl& control) = 0;

  std::unique_ptr<render::Session> prepare(const scene::Scene& scene, const render::RenderSettings& settings) override {
    return std::make_unique<OneShotSession>(*this, scene, settings);
  }

 private:
  class OneShotSession final : public render::Session, public render::PathRecorder {
   public:
    OneShotSession(OneShotRenderer& renderer, const scene::Scene& scene, const render::RenderSettings& settings)
        : renderer_(renderer), scene_(scene), settings_(settings) {}

    bool advance(render::SampleRange range, const render::RenderControl& control) override {
      settings_.image.sampleCount = range.end;
      result_ = renderer_.renderOnce(scene_, settings_, control);
      return !result_.interrupted;
    }
    void restrictTo(const render::PixelMask&) override { throw std::logic_error("this renderer traces all pixels"); }
    image::Film film() override { return result_.film; }
    void reset(std::uint32_t seed, std::uint32_t) override { settings_.image.seed = seed; }
    void setCamera(const scene::Camera&) override { throw std::logic_error("this renderer has no camera"); }
    void setView(const scene::Camera&, const render::Extent&) override {
      throw std::logic_error("this renderer has no camera");
    }
    void load(const image::Film&, std::uint32_t) override { throw std::logic_error("this renderer continues no film"); }
    render::RenderStatistics statistics() override {
      render::RenderStatistics statistics = result_.statistics;
      statistics.onGpu = renderer_.onGpu;
      return statistics;
    }
    render::PathRecorder* recorder() override { return this; }
    render::PathRecords paths() override { return result_.paths; }

   private:
    OneShotRenderer& renderer_;
    const scene::Scene& scene_;
    render::RenderSettings settings_;
    render::RenderResult result_;
  };
};

}  // namespace candela::test
