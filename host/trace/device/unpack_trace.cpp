// Unpacks the record of a replayed path.
#include "host/trace/device/unpack_trace.h"

#include <algorithm>
#include <bit>

#include "shaders/shared/render_data.h"

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
          .shadow = static_cast<render::ShadowOutcome>(rows.lightEntry.z),
          .primitive = rows.lightEntry.y,
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

}  // namespace

render::PathTrace unpackTrace(const gpu::TracedSample& rows) {
  render::PathTrace path;
  path.cameraNumbers = {rows.cameraNumbers.x, rows.cameraNumbers.y, rows.cameraNumbers.z, rows.cameraNumbers.w};
  path.vertexCount = rows.radianceCount.w;
  path.radiance = floats(rows.radianceCount);
  const std::uint32_t kept = std::min(path.vertexCount, gpu::kTracedVertices);
  for (std::uint32_t i = 0; i < kept; ++i) path.vertices.push_back(unpackVertex(rows.vertices[i]));
  return path;
}

}  // namespace candela::device
