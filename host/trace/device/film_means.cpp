// Runs film_means.comp on the film of a session.
#include "host/trace/device/film_means.h"

#include <span>

#include "host/base/divide_up.h"
#include "host/trace/device/gpu_session.h"
#include "host/trace/vulkan/binding_set.h"
#include "spirv/film_means.h"

namespace candela::device {
namespace {

constexpr std::uint32_t kGroupSide = 8;
constexpr std::uint64_t kPixelBytes = 16;

struct PushConstants {
  render::Extent film;
  render::Extent picture;
  float radianceOfOne;
};

}  // namespace

FilmMeans::FilmMeans(vulkan::Device device, const render::Extent& size)
    : device_(std::move(device)),
      size_(size),
      buffer_(device_, kPixelBytes * size.width * size.height, vulkan::Usage::storage),
      pipeline_(device_, spirv::film_means,
                {.bindings = {vulkan::BindingKind::storageBuffer, vulkan::BindingKind::storageBuffer},
                 .pushConstantBytes = sizeof(PushConstants)}) {
  buffer_.fill(0);
}

bool FilmMeans::update(render::Session& session) {
  const auto* const source = dynamic_cast<const GpuSession*>(&session);
  if (source == nullptr) return false;
  const DeviceFilm& film = source->deviceFilm();
  const vulkan::Buffer* const samples = film.buffer();
  if (samples == nullptr || !samples->isOn(device_)) return false;
  const vulkan::BindingSet bindings(pipeline_, {samples, &buffer_});
  const PushConstants push{film.size(), size_, film.radianceOfOne()};
  device_.run([&](vulkan::CommandRecorder& recorder) {
    recorder.dispatch(pipeline_, bindings, std::as_bytes(std::span(&push, 1)),
                      {divideUp(size_.width, kGroupSide), divideUp(size_.height, kGroupSide), 1});
  });
  return true;
}

}  // namespace candela::device
