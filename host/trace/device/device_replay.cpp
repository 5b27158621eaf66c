// Traces one sample of one pixel again on the device.
#include "host/trace/device/device_replay.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <memory>
#include <span>

#include "host/base/errors.h"
#include "host/trace/render/path_trace.h"
#include "host/trace/vulkan/binding_set.h"
#include "host/trace/vulkan/buffer.h"
#include "host/trace/vulkan/device.h"
#include "shaders/shared/render_data.h"
#include "shaders/shared/trace_rows.h"
#include "spirv/replay.h"

namespace candela::device {
namespace {

static_assert(render::PathTrace::kMaxVertices == gpu::kTracedVertices);
static_assert(render::LightTrace::kPointLight == gpu::kRecordMiss);

glm::dvec3 floats(const gpu::uvec4& row) {
  return {std::bit_cast<float>(row.x), std::bit_cast<float>(row.y), std::bit_cast<float>(row.z)};
}

glm::dvec3 floats(const gpu::vec4& row) { return glm::dvec3(row.x, row.y, row.z); }

render::HitTrace unpackHit(const gpu::TracedVertex& rows) {
  return {.primitive = rows.positionPrimitive.w,
          .material = rows.normalMaterial.w,
          .distance = rows.originDistance.w,
          .position = floats(rows.positionPrimitive),
          .normal = floats(rows.normalMaterial),
          .shadingNormal = floats(rows.shadingNormalLobe),
          .fromOutside = (rows.throughputStages.w & gpu::kTracedOutside) != 0};
}

render::LightTrace unpackLight(const gpu::TracedVertex& rows) {
  return {.entry = rows.lightEntry.x,
          .primitive = rows.lightEntry.y,
          .shadow = static_cast<render::ShadowOutcome>(rows.lightEntry.z),
          .direction = floats(rows.lightDirectionDistance),
          .distance = rows.lightDirectionDistance.w,
          .pdf = rows.lightDensities.x,
          .bsdfPdf = rows.lightDensities.y,
          .weight = rows.lightDensities.z,
          .radiance = floats(rows.lightRadiance)};
}

render::ScatteringTrace unpackScattering(const gpu::TracedVertex& rows) {
  return {.lobe = static_cast<render::Lobe>(rows.shadingNormalLobe.w),
          .direction = floats(rows.nextDirectionPdf),
          .pdf = rows.nextDirectionPdf.w,
          .weight = floats(rows.weightSurvival)};
}

render::VertexTrace unpackVertex(const gpu::TracedVertex& rows) {
  const std::uint32_t stages = rows.throughputStages.w;
  const auto went = [&](std::uint32_t stage) { return (stages & stage) != 0; };
  render::VertexTrace vertex;
  vertex.origin = floats(rows.originDistance);
  vertex.direction = floats(rows.directionPdf);
  vertex.pdf = rows.directionPdf.w;
  vertex.throughput = floats(rows.throughputStages);
  vertex.numbers = {rows.lightNumbers.x, rows.lightNumbers.y, rows.lightNumbers.z, rows.lightNumbers.w,
                    rows.bsdfNumbers.x,  rows.bsdfNumbers.y,  rows.bsdfNumbers.z};
  vertex.radiance = floats(rows.radiance);
  if (went(gpu::kTracedHit)) vertex.hit = unpackHit(rows);
  if (went(gpu::kTracedEmission))
    vertex.emission = render::EmissionTrace{floats(rows.emissionWeight), rows.emissionWeight.w};
  if (went(gpu::kTracedLight)) vertex.light = unpackLight(rows);
  if (went(gpu::kTracedScatter)) vertex.scattering = unpackScattering(rows);
  if (went(gpu::kTracedRoulette))
    vertex.roulette = render::RouletteTrace{rows.weightSurvival.w, went(gpu::kTracedSurvived)};
  return vertex;
}

render::PathTrace unpackTrace(const gpu::TracedSample& rows) {
  render::PathTrace path;
  path.cameraNumbers = {rows.cameraNumbers.x, rows.cameraNumbers.y, rows.cameraNumbers.z, rows.cameraNumbers.w};
  path.vertexCount = rows.radianceCount.w;
  path.radiance = floats(rows.radianceCount);
  const std::uint32_t kept = std::min(path.vertexCount, gpu::kTracedVertices);
  for (std::uint32_t i = 0; i < kept; ++i) path.vertices.push_back(unpackVertex(rows.vertices[i]));
  return path;
}

// Maximum number of segments of the single invocation in a dispatch: some milliseconds, even if a segment tests
// thousands of primitives.
constexpr std::uint32_t kSegmentsPerDispatch = 64;

// Returns the state of a path of this sample that has not started.
gpu::PathState stateBefore(const render::PixelSample& sample) {
  gpu::PathState state{};
  state.radianceSample.w = sample.index;
  return state;
}

}  // namespace

Kernel replayKernel() { return {render::KernelInUse::replay, {spirv::replay}, sizeof(gpu::PathState), nullptr}; }

render::PathTrace replayOnDevice(vulkan::Device& device, const vulkan::ComputePipeline& pipeline,
                                 const DeviceScene& scene, const render::PixelSample& sample, std::uint32_t maxDepth,
                                 const LoopBudget& budget, render::RenderStatistics& statistics) {
  vulkan::Buffer state(device, sizeof(gpu::PathState), vulkan::Usage::storage);
  vulkan::Buffer noFilm(device, sizeof(gpu::FilmRows), vulkan::Usage::storage);
  vulkan::Buffer results(device, sizeof(gpu::Counters) + sizeof(gpu::TracedSample), vulkan::Usage::storage);
  const vulkan::BindingSet bindings(pipeline,
                                    {&scene.rows(), &state, &noFilm, &results, &scene.texels(), &scene.uniforms()});
  const gpu::PathState before = stateBefore(sample);
  state.upload(std::as_bytes(std::span(&before, 1)));
  results.fill(0);

  gpu::DispatchConstants constants{};
  constants.regionOrigin = {sample.x, sample.y};
  constants.regionSize = {1, 1};
  constants.maxSegments = std::min(kSegmentsPerDispatch, budget.maxSegments);
  constants.maxIterations = budget.maxIterations;
  gpu::Counters counters{};
  // Each dispatch traces a segment at least, and a path has no more than `maxDepth`.
  for (std::uint32_t i = 0; counters.finishedSamples == 0 && counters.truncated == 0; ++i) {
    if (i == maxDepth)
      throw DeviceLostError(fmt::format("{} ({}) reports success, but does not trace the sample to its end",
                                        device.info().name, device.info().driver));
    device.run([&](vulkan::CommandRecorder& recorder) {
      recorder.dispatch(pipeline, bindings, std::as_bytes(std::span(&constants, 1)), {1, 1, 1});
    });
    results.download(std::as_writable_bytes(std::span(&counters, 1)));
  }
  statistics.truncated += counters.truncated;
  const auto rows = std::make_unique<gpu::TracedSample>();
  results.download(std::as_writable_bytes(std::span(rows.get(), 1)), sizeof counters);
  return unpackTrace(*rows);
}

}  // namespace candela::device
