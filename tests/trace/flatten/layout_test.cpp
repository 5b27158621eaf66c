// Host and shader agree on the offset of every member of every structure that they share.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstddef>
#include <cstring>
#include <map>
#include <string>

#include "host/image/film.h"
#include "host/trace/render/path_record.h"
#include "shaders/shared/render_data.h"
#include "shaders/shared/trace_rows.h"
#include "spirv/path.h"
#include "spirv/replay.h"
#include "spirv/wave_shade.h"

using namespace candela;

namespace {

using Offsets = std::map<std::string, std::uint32_t>;

// Member offsets of the module's structures by name, read from its debug names and decorations.
class Module {
 public:
  explicit Module(std::span<const std::uint32_t> words) {
    constexpr std::uint32_t kHeaderWords = 5;
    for (std::size_t at = kHeaderWords; at < words.size(); at += words[at] >> 16) {
      readInstruction(words[at] & 0xffff, words.subspan(at, words[at] >> 16));
    }
  }

  // The structure of this name that has explicit offsets. SPIR-V has one copy per layout.
  Offsets offsetsOf(const std::string& name) const {
    for (const auto& [id, structName] : names_) {
      if (structName != name || !offsets_.contains(id)) continue;
      Offsets result;
      for (const auto& [member, offset] : offsets_.at(id)) result[memberNames_.at(id).at(member)] = offset;
      return result;
    }
    return {};
  }

  bool mentions(const std::string& name) const {
    return std::ranges::any_of(names_, [&](const auto& entry) { return entry.second == name; });
  }

 private:
  static constexpr std::uint32_t kOpName = 5, kOpMemberName = 6, kOpMemberDecorate = 72, kDecorationOffset = 35;

  void readInstruction(std::uint32_t opcode, std::span<const std::uint32_t> words) {
    if (opcode == kOpName) names_[words[1]] = text(words.subspan(2));
    if (opcode == kOpMemberName) memberNames_[words[1]][words[2]] = text(words.subspan(3));
    if (opcode == kOpMemberDecorate && words[3] == kDecorationOffset) offsets_[words[1]][words[2]] = words[4];
  }

  static std::string text(std::span<const std::uint32_t> words) {
    const char* begin = reinterpret_cast<const char*>(words.data());
    return std::string(begin, strnlen(begin, words.size() * 4));
  }

  std::map<std::uint32_t, std::string> names_;
  std::map<std::uint32_t, std::map<std::uint32_t, std::string>> memberNames_;
  std::map<std::uint32_t, std::map<std::uint32_t, std::uint32_t>> offsets_;
};

#define MEMBER(type, member) \
  { #member, static_cast < std::uint32_t>(offsetof(gpu::type, member)) }

}  // namespace

TEST_CASE("shared structures have the same layout in SPIR-V and in C++") {
  const Module module(spirv::path);
  CHECK(module.offsetsOf("RenderConstants") == Offsets{MEMBER(RenderConstants, cameraOrigin),
                                                       MEMBER(RenderConstants, pixelOriginX),
                                                       MEMBER(RenderConstants, cameraForward),
                                                       MEMBER(RenderConstants, pixelOriginY),
                                                       MEMBER(RenderConstants, cameraRight),
                                                       MEMBER(RenderConstants, inversePixelsAcross),
                                                       MEMBER(RenderConstants, cameraUp),
                                                       MEMBER(RenderConstants, inversePixelsDown),
                                                       MEMBER(RenderConstants, lensRight),
                                                       MEMBER(RenderConstants, inverseFocal),
                                                       MEMBER(RenderConstants, lensUp),
                                                       MEMBER(RenderConstants, firstSurfaceRow),
                                                       MEMBER(RenderConstants, background),
                                                       MEMBER(RenderConstants, aoDistance),
                                                       MEMBER(RenderConstants, imageWidth),
                                                       MEMBER(RenderConstants, imageHeight),
                                                       MEMBER(RenderConstants, seed),
                                                       MEMBER(RenderConstants, strataPerSide),
                                                       MEMBER(RenderConstants, maxDepth),
                                                       MEMBER(RenderConstants, rouletteStart),
                                                       MEMBER(RenderConstants, lightCount),
                                                       MEMBER(RenderConstants, stateRows),
                                                       MEMBER(RenderConstants, firstStructureRow),
                                                       MEMBER(RenderConstants, firstPrimitiveRow),
                                                       MEMBER(RenderConstants, firstMaterialRow),
                                                       MEMBER(RenderConstants, firstLightRow),
                                                       MEMBER(RenderConstants, firstGeometryRow),
                                                       MEMBER(RenderConstants, firstSkyRow),
                                                       MEMBER(RenderConstants, firstPlaneSlot),
                                                       MEMBER(RenderConstants, slotCount),
                                                       MEMBER(RenderConstants, gridLow),
                                                       MEMBER(RenderConstants, gridReach),
                                                       MEMBER(RenderConstants, gridHigh),
                                                       MEMBER(RenderConstants, firstEnergyRow),
                                                       MEMBER(RenderConstants, gridScale),
                                                       MEMBER(RenderConstants, firstTextureRow),
                                                       MEMBER(RenderConstants, gridWidth),
                                                       MEMBER(RenderConstants, indirectLimit),
                                                       MEMBER(RenderConstants, gridSides),
                                                       MEMBER(RenderConstants, firstItemRow),
                                                       MEMBER(RenderConstants, gridStrides),
                                                       MEMBER(RenderConstants, environmentProbability),
                                                       MEMBER(RenderConstants, environmentX),
                                                       MEMBER(RenderConstants, environmentWidth),
                                                       MEMBER(RenderConstants, environmentY),
                                                       MEMBER(RenderConstants, environmentHeight),
                                                       MEMBER(RenderConstants, environmentZ),
                                                       MEMBER(RenderConstants, firstEnvironmentRow),
                                                       MEMBER(RenderConstants, firstInstanceRow),
                                                       MEMBER(RenderConstants, topNode),
                                                       MEMBER(RenderConstants, firstAttributeRow),
                                                       MEMBER(RenderConstants, firstLightTreeRow),
                                                       MEMBER(RenderConstants, environmentSize),
                                                       MEMBER(RenderConstants, environmentPole),
                                                       MEMBER(RenderConstants, environmentRows)});
  CHECK(module.offsetsOf("RenderUniforms") ==
        Offsets{MEMBER(RenderUniforms, constants), MEMBER(RenderUniforms, slotRows)});
  CHECK(module.offsetsOf("DispatchConstants") ==
        Offsets{MEMBER(DispatchConstants, regionOrigin), MEMBER(DispatchConstants, regionSize),
                MEMBER(DispatchConstants, firstRow), MEMBER(DispatchConstants, maxSegments),
                MEMBER(DispatchConstants, sampleEnd), MEMBER(DispatchConstants, maxIterations),
                MEMBER(DispatchConstants, roundParity), MEMBER(DispatchConstants, bandPixels),
                MEMBER(DispatchConstants, firstColumn)});
  CHECK(module.offsetsOf("PathState") == Offsets{MEMBER(PathState, originPdf), MEMBER(PathState, directionAndSlot),
                                                 MEMBER(PathState, throughputDepth), MEMBER(PathState, radianceSample),
                                                 MEMBER(PathState, counts), MEMBER(PathState, instances)});
  CHECK(module.offsetsOf("PathCounts") == Offsets{MEMBER(PathCounts, bounceRays), MEMBER(PathCounts, shadowRays),
                                                  MEMBER(PathCounts, vertices), MEMBER(PathCounts, steps)});
  CHECK(module.offsetsOf("FilmRows") == Offsets{MEMBER(FilmRows, red), MEMBER(FilmRows, green), MEMBER(FilmRows, blue),
                                                MEMBER(FilmRows, luminanceSquared)});
  CHECK(module.offsetsOf("Counters") == Offsets{MEMBER(Counters, finishedPixels), MEMBER(Counters, truncated),
                                                MEMBER(Counters, finishedSamples), MEMBER(Counters, volumeFaults)});
}

TEST_CASE("the wavefront's structures have the same layout in SPIR-V and in C++, and begin like the megakernel's") {
  const Module module(spirv::wave_shade);
  const Offsets waves{MEMBER(WaveState, path), MEMBER(WaveState, hit), MEMBER(WaveState, shadowLimit),
                      MEMBER(WaveState, shadowDirection), MEMBER(WaveState, shadowLight)};
  CHECK(module.offsetsOf("WaveState") == waves);
  CHECK(waves.at("path") == 0);
  CHECK(module.offsetsOf("QueueHeader") == Offsets{MEMBER(QueueHeader, groupsX), MEMBER(QueueHeader, groupsY),
                                                   MEMBER(QueueHeader, groupsZ), MEMBER(QueueHeader, count)});
  for (const char* name :
       {"PathState", "PathCounts", "FilmRows", "Counters", "DispatchConstants", "RenderConstants", "RenderUniforms"}) {
    CAPTURE(name);
    CHECK(module.offsetsOf(name) == Module(spirv::path).offsetsOf(name));
  }
}

TEST_CASE("the records of a replayed sample have the same layout in SPIR-V and in C++, and are in no other kernel") {
  const Module module(spirv::replay);
  const Offsets vertex{MEMBER(TracedVertex, originDistance),   MEMBER(TracedVertex, directionPdf),
                       MEMBER(TracedVertex, throughputStages), MEMBER(TracedVertex, positionPrimitive),
                       MEMBER(TracedVertex, normalMaterial),   MEMBER(TracedVertex, shadingNormalLobe),
                       MEMBER(TracedVertex, emissionWeight),   MEMBER(TracedVertex, lightDirectionDistance),
                       MEMBER(TracedVertex, lightEntry),       MEMBER(TracedVertex, lightDensities),
                       MEMBER(TracedVertex, lightRadiance),    MEMBER(TracedVertex, nextDirectionPdf),
                       MEMBER(TracedVertex, weightSurvival),   MEMBER(TracedVertex, radiance),
                       MEMBER(TracedVertex, lightNumbers),     MEMBER(TracedVertex, bsdfNumbers)};
  CHECK(vertex.size() * sizeof(gpu::uvec4) == sizeof(gpu::TracedVertex));
  CHECK(module.offsetsOf("TracedVertex") == vertex);
  CHECK(module.offsetsOf("TracedSample") == Offsets{MEMBER(TracedSample, cameraNumbers),
                                                    MEMBER(TracedSample, radianceCount),
                                                    MEMBER(TracedSample, vertices)});
  CHECK(module.offsetsOf("PathState") == Module(spirv::path).offsetsOf("PathState"));
  CHECK_FALSE(module.mentions("FilmRows"));
  CHECK_FALSE(Module(spirv::path).mentions("TracedVertex"));
}

TEST_CASE("the host's pixel of the film has the layout that the device writes") {
  CHECK(sizeof(gpu::FilmRows) == sizeof(image::FilmPixel));
  CHECK(offsetof(image::FilmPixel, red) == offsetof(gpu::FilmRows, red));
  CHECK(offsetof(image::FilmPixel, sampleCount) == offsetof(gpu::FilmRows, red) + 12);
  CHECK(offsetof(image::FilmPixel, green) == offsetof(gpu::FilmRows, green));
  CHECK(offsetof(image::FilmPixel, badCount) == offsetof(gpu::FilmRows, green) + 12);
  CHECK(offsetof(image::FilmPixel, blue) == offsetof(gpu::FilmRows, blue));
  CHECK(offsetof(image::FilmPixel, firstBadSample) == offsetof(gpu::FilmRows, blue) + 12);
  CHECK(offsetof(image::FilmPixel, luminanceSquared) == offsetof(gpu::FilmRows, luminanceSquared));
}

TEST_CASE("path records have the same values on both tracers") {
  CHECK(render::PathRecord::kRecordedVertices == gpu::kRecordedVertices);
  CHECK(render::VertexRecord::kMiss == gpu::kRecordMiss);
  CHECK(static_cast<std::uint32_t>(render::ShadowOutcome::notTraced) == gpu::kShadowNotTraced);
  CHECK(static_cast<std::uint32_t>(render::ShadowOutcome::visible) == gpu::kShadowVisible);
  CHECK(static_cast<std::uint32_t>(render::ShadowOutcome::occluded) == gpu::kShadowOccluded);
}
