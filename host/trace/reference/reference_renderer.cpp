// Creates the reference tracer.
#include "host/trace/reference/reference_renderer.h"

#include "host/trace/reference/reference_session.h"

namespace candela::reference {
namespace {

class ReferenceRenderer final : public render::Renderer {
 public:
  std::unique_ptr<render::Session> prepare(const scene::Scene& scene, const render::RenderSettings& settings) override {
    return std::make_unique<ReferenceSession>(scene, settings);
  }
};

}  // namespace

std::unique_ptr<render::Renderer> makeReferenceRenderer() { return std::make_unique<ReferenceRenderer>(); }

}  // namespace candela::reference
