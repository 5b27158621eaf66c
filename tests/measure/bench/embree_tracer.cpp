// Traces a benchmark's rays with Embree 3.
#include "tests/measure/bench/embree_tracer.h"

#include <atomic>
#include <bit>
#include <cmath>
#include <limits>
#include <thread>

#include "host/base/errors.h"
#include "host/base/stopwatch.h"

namespace candela::bench {
namespace {

constexpr unsigned kTriangles = 0;
constexpr unsigned kSpheres = 1;
constexpr std::size_t kRaysAtATime = 1024;
constexpr float kDeviceNoHit = 3.402823e38f;  // as in kernels

RTCRay rayOf(const gpu::CastRay& given) {
  RTCRay ray{};
  ray.org_x = given.originLimit.x;
  ray.org_y = given.originLimit.y;
  ray.org_z = given.originLimit.z;
  ray.dir_x = given.direction.x;
  ray.dir_y = given.direction.y;
  ray.dir_z = given.direction.z;
  ray.tfar = given.originLimit.w;
  ray.mask = ~0u;
  return ray;
}

}  // namespace

EmbreeTracer::EmbreeTracer(const scene::Scene& scene) : device_(rtcNewDevice(nullptr)), scene_(nullptr) {
  if (device_ == nullptr) throw FileError("Embree has no device");
  scene_ = rtcNewScene(device_);
  addTriangles(scene);
  addSpheres(scene);
  if (indices_[kTriangles].size() + indices_[kSpheres].size() != scene.primitives.size()) {
    throw FileError(scene.name + ": has primitives other than triangles and spheres");
  }
  rtcCommitScene(scene_);
}

EmbreeTracer::~EmbreeTracer() {
  rtcReleaseScene(scene_);
  rtcReleaseDevice(device_);
}

void EmbreeTracer::addTriangles(const scene::Scene& scene) {
  for (std::uint32_t i = 0; i < scene.primitives.size(); ++i) {
    if (scene.primitives[i].kind == scene::PrimitiveKind::triangle) indices_[kTriangles].push_back(i);
  }
  const std::size_t count = indices_[kTriangles].size();
  RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<glm::vec3*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), 3 * count));
  auto* corners = static_cast<std::uint32_t*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), count));
  for (std::size_t i = 0; i < 3 * count; ++i) {
    vertices[i] = triangleOf(scene, scene.primitives[indices_[kTriangles][i / 3]]).p[i % 3];
    corners[i] = static_cast<std::uint32_t>(i);
  }
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(scene_, geometry, kTriangles);
  rtcReleaseGeometry(geometry);
}

void EmbreeTracer::addSpheres(const scene::Scene& scene) {
  for (std::uint32_t i = 0; i < scene.primitives.size(); ++i) {
    if (scene.primitives[i].kind == scene::PrimitiveKind::sphere) indices_[kSpheres].push_back(i);
  }
  const std::size_t count = indices_[kSpheres].size();
  RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_SPHERE_POINT);
  auto* rows = static_cast<glm::vec4*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, sizeof(glm::vec4), count));
  for (std::size_t i = 0; i < count; ++i) {
    const scene::Sphere& sphere = scene.spheres[scene.primitives[indices_[kSpheres][i]].index];
    rows[i] = glm::vec4(sphere.centre, std::abs(sphere.radius));
  }
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(scene_, geometry, kSpheres);
  rtcReleaseGeometry(geometry);
}

void EmbreeTracer::load(std::span<const gpu::CastRay> rays, bool anyHit) {
  rays_.assign(rays.begin(), rays.end());
  hits_.assign(rays.size(), {});
  anyHit_ = anyHit;
}

double EmbreeTracer::trace() {
  Stopwatch watch;
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t first; (first = next.fetch_add(kRaysAtATime)) < rays_.size();) {
      traceRange(first, std::min(first + kRaysAtATime, rays_.size()));
    }
  };
  {
    std::vector<std::jthread> threads;
    for (unsigned i = 1; i < std::thread::hardware_concurrency(); ++i) threads.emplace_back(work);
    work();
  }
  return watch.lap();
}

void EmbreeTracer::traceRange(std::size_t first, std::size_t end) {
  for (std::size_t i = first; i < end; ++i) hits_[i] = anyHit_ ? any(rays_[i]) : closest(rays_[i]);
}

gpu::CastHit EmbreeTracer::closest(const gpu::CastRay& ray) const {
  RTCRayHit query{rayOf(ray), {}};
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene_, &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID)
    return {{std::bit_cast<std::uint32_t>(kDeviceNoHit), gpu::kNoPrimitive, 0, 0}};
  return {{std::bit_cast<std::uint32_t>(query.ray.tfar), indices_[query.hit.geomID][query.hit.primID], 0, 0}};
}

gpu::CastHit EmbreeTracer::any(const gpu::CastRay& ray) const {
  RTCRay query = rayOf(ray);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(scene_, &context, &query);
  return {{0, query.tfar < 0 ? 1u : 0u, 0, 0}};
}

}  // namespace candela::bench
