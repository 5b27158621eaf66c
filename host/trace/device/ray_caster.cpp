// Traces given rays on a device, for benchmarks and tests.
#include "host/trace/device/ray_caster.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <numeric>
#include <utility>

#include "host/base/divide_up.h"
#include "host/base/errors.h"
#include "host/trace/device/specialise.h"
#include "host/trace/device/workgroup.h"
#include "host/trace/vulkan/loop_limit.h"
#include "spirv/cast_rays.h"
#include "spirv/make_rays.h"

namespace candela::device {
namespace {

constexpr std::uint32_t kFirstChunk = 1u << 14;
constexpr std::uint32_t kLastChunk = 1u << 21;
constexpr double kShortSeconds = 0.025;  // a shorter dispatch may be twice as large

std::uint32_t invocationsOf(const render::Extent& workgroup) { return workgroup.width * workgroup.height; }

// Returns a number that is coprime to `units` and near their golden section. Any run of units is then spread over all
// of the rays.
std::uint32_t strideOver(std::uint32_t units) {
  auto stride = std::max(1u, static_cast<std::uint32_t>(units / std::numbers::phi));
  while (std::gcd(stride, units) != 1) ++stride;
  return stride;
}

// Moves bit i to bit 2 i.
std::uint32_t spread(std::uint32_t bits) {
  std::uint32_t result = 0;
  for (std::uint32_t i = 0; i < 16; ++i) result |= (bits >> i & 1) << (2 * i);
  return result;
}

// Returns the row-major indices of an image's pixels along Morton's curve, so that the invocations of a subgroup have
// neighbours on all sides.
std::vector<std::uint32_t> alongMortonCurve(const render::Extent& size) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> keyed;
  keyed.reserve(std::size_t{size.width} * size.height);
  for (std::uint32_t y = 0; y < size.height; ++y) {
    for (std::uint32_t x = 0; x < size.width; ++x) keyed.emplace_back(spread(x) | spread(y) << 1, y * size.width + x);
  }
  std::sort(keyed.begin(), keyed.end());
  std::vector<std::uint32_t> pixels;
  pixels.reserve(keyed.size());
  for (const auto& [key, pixel] : keyed) pixels.push_back(pixel);
  return pixels;
}

vulkan::ComputePipeline castPipeline(vulkan::Device& device, std::span<const std::uint32_t> spirv, const CodeForm& form,
                                     const flatten::SceneShape& shape, const render::RenderSettings& settings,
                                     bool texels, bool anyHit) {
  vulkan::PipelineOptions options = kernelOptions(form, shape, settings, texels, sizeof(gpu::CastConstants));
  options.specialisations.push_back({gpu::kSpecOcclusion, anyHit});
  return {device, spirv, options};
}

vulkan::Buffer storage(vulkan::Device& device, std::uint64_t count, std::uint64_t bytes) {
  return {device, std::max<std::uint64_t>(count, 1) * bytes, vulkan::Usage::storage};
}

const render::RenderSettings& checked(const vulkan::Device& device, const render::RenderSettings& settings) {
  requireWorkgroup(device.info(), settings.execution.workgroupInUse());
  return settings;
}

}  // namespace

RayCaster::RayCaster(vulkan::Device& device, const flatten::FlatScene& flat, const render::RenderSettings& settings)
    : device_(device),
      settings_(checked(device, settings)),
      form_(codeFormOf(device.info(), vulkan::probeLoopLimit(device))),
      shape_(flat.shape),
      sceneBytes_(std::span(flat.rows).size_bytes()),
      deviceScene_(device, flat, loadsFor(device.info(), flat, settings)),
      casts_{castPipeline(device, spirv::cast_rays, form_, shape_, settings, deviceScene_.readsTexels(), false),
             castPipeline(device, spirv::cast_rays, form_, shape_, settings, deviceScene_.readsTexels(), true)},
      unused_(storage(device, 1, sizeof(gpu::CastHit))),
      rays_(storage(device, 1, sizeof(gpu::CastRay))),
      hits_(storage(device, 1, sizeof(gpu::CastHit))),
      chunk_(kFirstChunk) {}

double RayCaster::dispatch(const vulkan::ComputePipeline& pipeline, const vulkan::BindingSet& bindings,
                           std::uint32_t count) {
  const std::uint32_t invocations = invocationsOf(settings_.execution.workgroupInUse());
  double seconds = 0;
  for (std::uint32_t first = 0; first < count;) {
    const std::uint32_t end = first + std::min(count - first, chunk_);
    const std::uint32_t units = divideUp(divideUp(end - first, invocations), gpu::kCastUnit);
    const gpu::CastConstants constants{first, end, invocations, strideOver(units)};
    const double took = device_.run([&](vulkan::CommandRecorder& recorder) {
      recorder.dispatch(pipeline, bindings, std::as_bytes(std::span(&constants, 1)), {units * gpu::kCastUnit});
    });
    seconds += took;
    const bool whole = end - first == chunk_;
    first = end;
    if (whole && took < kShortSeconds)
      chunk_ = std::min({2 * chunk_, kLastChunk, 65535 / gpu::kCastUnit * gpu::kCastUnit * invocations});
  }
  return seconds;
}

RaySets RayCaster::makeRays() {
  const vulkan::ComputePipeline pipeline = castPipeline(device_, spirv::make_rays, form_, shape_, settings_,
                                                        readsTexels(), false);
  const std::uint32_t pixels = settings_.image.size.width * settings_.image.size.height;
  const vulkan::Buffer all = storage(device_, std::uint64_t{gpu::kRayKindCount} * pixels, sizeof(gpu::CastRay));
  const vulkan::BindingSet bindings(
      pipeline, {&deviceScene_.rows(), &all, &hits_, &unused_, &deviceScene_.texels(), &deviceScene_.uniforms()});
  dispatch(pipeline, bindings, pixels);
  std::vector<gpu::CastRay> made(std::size_t{gpu::kRayKindCount} * pixels);
  all.download(std::as_writable_bytes(std::span(made)));
  RaySets sets;
  for (const std::uint32_t pixel : alongMortonCurve(settings_.image.size)) {
    for (std::uint32_t kind = 0; kind < gpu::kRayKindCount; ++kind) {
      const gpu::CastRay& ray = made[std::size_t{pixel} * gpu::kRayKindCount + kind];
      if (kind == gpu::kPrimaryRay && ray.direction.w != 0)
        throw InternalError("the device stopped a loop while rays were generated");
      if (ray.originLimit.w > 0) sets[kind].push_back(ray);
    }
  }
  return sets;
}

void RayCaster::load(std::span<const gpu::CastRay> rays, bool anyHit) {
  rayCount_ = static_cast<std::uint32_t>(rays.size());
  anyHit_ = anyHit;
  rays_ = storage(device_, rays.size(), sizeof(gpu::CastRay));
  hits_ = storage(device_, rays.size(), sizeof(gpu::CastHit));
  if (!rays.empty()) rays_.upload(std::as_bytes(rays));
}

double RayCaster::trace() {
  const vulkan::ComputePipeline& pipeline = casts_[anyHit_];
  const vulkan::BindingSet bindings(
      pipeline, {&deviceScene_.rows(), &rays_, &hits_, &unused_, &deviceScene_.texels(), &deviceScene_.uniforms()});
  return dispatch(pipeline, bindings, rayCount_);
}

std::vector<gpu::CastHit> RayCaster::hits() const {
  std::vector<gpu::CastHit> result(rayCount_);
  if (!result.empty()) hits_.download(std::as_writable_bytes(std::span(result)));
  const bool stopped = std::any_of(result.begin(), result.end(),
                                   [](const gpu::CastHit& hit) { return hit.found.w != 0; });
  if (stopped) throw InternalError("the device stopped the traversal of a ray");
  return result;
}

}  // namespace candela::device
