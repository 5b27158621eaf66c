// Renders with a device that records its work.
#include "host/drivers/capture/sample_trial.h"

#include <algorithm>
#include <cstddef>
#include <cstring>

#include "host/base/errors.h"
#include "host/drivers/capture/replay.h"
#include "host/drivers/capture/sample_values.h"
#include "host/trace/device/gpu_renderer.h"
#include "host/trace/reference/reference_renderer.h"
#include "shaders/shared/render_data.h"

namespace candela::capture {
namespace {

using vulkan::RecordedDispatch;

std::unique_ptr<render::Renderer> rendererOn(const TrialDevice& device, std::shared_ptr<vulkan::Recording> recording) {
  vulkan::DeviceOptions options;
  options.subgroupSize = device.subgroupSize;
  options.prepareShader = device.prepareShader;
  options.recording = std::move(recording);
  return device::makeGpuRenderer(vulkan::Device::open(device.info, options));
}

image::Film renderSample(render::Renderer& renderer, const scene::Scene& scene, const Sample& sample) {
  const std::unique_ptr<render::Session> session = renderer.prepare(scene, sample.settings);
  session->advance({sample.index, sample.index + 1}, {});
  return session->film();
}

std::uint32_t& maxSegmentsOf(RecordedDispatch& dispatch) {
  return *reinterpret_cast<std::uint32_t*>(&dispatch.pushConstants[offsetof(gpu::DispatchConstants, maxSegments)]);
}

// Returns the first dispatch, with the segments of all dispatches.
vulkan::Recording asOneDispatch(const vulkan::Recording& recording) {
  vulkan::Recording one = recording;
  std::uint32_t segments = 0;
  auto first = one.commands.end();
  for (auto command = one.commands.begin(); command != one.commands.end(); ++command) {
    auto* const dispatch = std::get_if<RecordedDispatch>(&*command);
    if (dispatch == nullptr) continue;
    segments += maxSegmentsOf(*dispatch);
    if (first == one.commands.end()) first = command;
  }
  maxSegmentsOf(std::get<RecordedDispatch>(*first)) = segments;
  one.commands.erase(first + 1, one.commands.end());
  return one;
}

bool givesFilm(const Capture& capture, const vulkan::DeviceInfo& device, const image::Film& film) {
  const std::vector<Content> contents = replay(capture, device);
  const Content& found = contents[lastDispatch(capture.work).buffers[kFilmBinding]];
  const std::span wanted = std::as_bytes(std::span(film.pixels()));
  return std::equal(wanted.begin(), wanted.end(), found.begin());
}

}  // namespace

SampleTrial::SampleTrial(const TrialDevice& device, const std::optional<TrialDevice>& other)
    : info_(device.info),
      recording_(std::make_shared<vulkan::Recording>()),
      device_(rendererOn(device, recording_)),
      expected_(other ? rendererOn(*other, {}) : reference::makeReferenceRenderer()),
      expectsBits_(other.has_value()) {}

image::Film SampleTrial::render(const scene::Scene& scene, const Sample& sample) {
  recording_->commands.clear();
  return renderSample(*device_, scene, sample);
}

ExpectedValues SampleTrial::expectedOf(const scene::Scene& scene, const Sample& sample) {
  return expectsBits_ ? bitsOf(renderSample(*expected_, scene, sample))
                      : expectedFilm(scene, sample.settings, sample.index, *expected_);
}

std::size_t SampleTrial::differing(const scene::Scene& scene, const Sample& sample) {
  const ExpectedValues expected = expectedOf(scene, sample);
  return expected.empty() ? 0 : differingCount(render(scene, sample), expected);
}

bool SampleTrial::fails(const scene::Scene& scene, const Sample& sample) {
  try {
    return differing(scene, sample) > 0;
  } catch (const UsageError&) {
    return false;
  } catch (const FileError&) {
    return false;
  }
}

Capture SampleTrial::capture(const scene::Scene& scene, const Sample& sample) {
  const image::Film film = render(scene, sample);
  Capture all = cutDown(*recording_);
  if (all.work.shaders.size() == 1) {
    Capture one = cutDown(asOneDispatch(*recording_));
    if (givesFilm(one, info_, film)) all = std::move(one);
  }
  all.expected = expectedOf(scene, sample);
  return all;
}

}  // namespace candela::capture
