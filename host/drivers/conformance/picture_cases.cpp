// The table of pictures: kernels, layouts, loads, integrators, samplers, materials and workgroups.
#include <fmt/format.h>

#include <array>

#include "host/drivers/conformance/case_tables.h"
#include "host/drivers/conformance/identity_run.h"
#include "host/drivers/conformance/picture_run.h"
#include "host/drivers/conformance/scenes.h"
#include "host/drivers/conformance/workbench.h"

namespace candela::conformance {
namespace {

using render::AccelKind;
using render::BvhLayout;
using render::BvhSplit;
using render::Extent;
using render::Integrator;
using render::KernelKind;
using render::SamplerKind;
using render::SceneLoads;

constexpr std::uint32_t kSide = 24;
constexpr std::uint32_t kSamples = 8;
constexpr std::uint32_t kWhittedDepth = 5;

template <class Value>
struct Named {
  const char* name;
  Value value;
};

struct Structure {
  AccelKind accel;
  BvhSplit split;
  BvhLayout layout;
};

constexpr std::array<Named<KernelKind>, 2> kKernels{
    {{"megakernel", KernelKind::megakernel}, {"wavefront", KernelKind::wavefront}}};
constexpr std::array<Named<Structure>, 4> kStructures{
    {{"grid", {AccelKind::grid, BvhSplit::sah, BvhLayout::automatic}},
     {"midpoint", {AccelKind::bvh, BvhSplit::midpoint, BvhLayout::bvh2}},
     {"bvh2", {AccelKind::bvh, BvhSplit::sah, BvhLayout::bvh2}},
     {"cwbvh", {AccelKind::bvh, BvhSplit::sah, BvhLayout::cwbvh}}}};
constexpr std::array<Named<SceneLoads>, 2> kLoads{{{"texel", SceneLoads::texel}, {"storage", SceneLoads::storage}}};
constexpr std::array<Named<Integrator>, 6> kIntegrators{{{"whitted", Integrator::whitted},
                                                         {"ao", Integrator::ao},
                                                         {"normal", Integrator::normal},
                                                         {"albedo", Integrator::albedo},
                                                         {"depth", Integrator::depth},
                                                         {"id", Integrator::id}}};
constexpr std::array<Named<SamplerKind>, 2> kSamplers{
    {{"independent", SamplerKind::independent}, {"stratified", SamplerKind::stratified}}};
constexpr std::array<Named<Extent>, 5> kWorkgroups{
    {{"1x1", {1, 1}}, {"3x5", {3, 5}}, {"32x1", {32, 1}}, {"1x64", {1, 64}}, {"16x16", {16, 16}}}};

Picture basicPicture(const std::string& scene = "cornell") {
  Picture picture;
  picture.scene = scene;
  picture.request.size = Extent{kSide, kSide};
  picture.request.sampleCount = kSamples;
  picture.request.accel = AccelKind::bvh;
  picture.request.execution.threads = 1;
  picture.request.execution.kernel = KernelKind::megakernel;
  picture.request.structure.bvhLayout = BvhLayout::cwbvh;
  return picture;
}

class Table {
 public:
  explicit Table(const PictureTest& test) : test_(test) {}

  void add(const std::string& path, const std::string& group, Picture picture) {
    picture.request.image.seed = test_.seed;
    picture.alpha = test_.alpha;
    cases_.push_back({fmt::format("kernel.{}.{}", path, picture.scene), "kernel." + group,
                      [picture](Workbench& bench) { return comparePicture(picture, bench); },
                      [picture](Workbench& bench) { return compilePicture(picture, bench); },
                      [picture](const vulkan::DeviceInfo& device) { return capturePicture(picture, device); }});
  }
  Cases take() { return std::move(cases_); }

 private:
  PictureTest test_;
  Cases cases_;
};

// Tests of all primitives in sequence read the uniform buffer, so that loads make no difference.
void addSequences(Table& table) {
  for (const auto& [kernelName, kernel] : kKernels) {
    Picture picture = basicPicture();
    picture.request.accel = AccelKind::none;
    picture.request.structure.bvhLayout = BvhLayout::automatic;
    picture.request.execution.kernel = kernel;
    table.add(fmt::format("{}.layout.sequential", kernelName), kernelName, picture);
  }
}

void addStructures(Table& table) {
  for (const auto& [kernelName, kernel] : kKernels) {
    for (const auto& [structureName, structure] : kStructures) {
      for (const auto& [loadsName, loads] : kLoads) {
        Picture picture = basicPicture();
        picture.request.accel = structure.accel;
        picture.request.structure.bvhSplit = structure.split;
        picture.request.structure.bvhLayout = structure.layout;
        picture.request.execution.kernel = kernel;
        picture.request.execution.sceneLoads = loads;
        table.add(fmt::format("{}.layout.{}.{}", kernelName, structureName, loadsName), kernelName, picture);
      }
    }
  }
}

void addScenes(Table& table) {
  for (const auto& [kernelName, kernel] : kKernels) {
    for (const char* const scene : {"primitives", "depth_of_field", "terrain"}) {
      Picture picture = basicPicture(scene);
      picture.request.execution.kernel = kernel;
      table.add(fmt::format("{}.scene", kernelName), "scene", picture);
    }
  }
}

void addIntegrators(Table& table) {
  for (const auto& [name, integrator] : kIntegrators) {
    Picture picture = basicPicture("primitives");
    picture.request.image.integrator = integrator;
    if (integrator == Integrator::whitted) picture.request.maxDepth = kWhittedDepth;
    table.add(fmt::format("integrator.{}", name), "integrator", picture);
  }
}

void addSamplers(Table& table) {
  for (const auto& [name, sampler] : kSamplers) {
    Picture picture = basicPicture();
    picture.request.image.sampler = sampler;
    table.add(fmt::format("megakernel.sampler.{}", name), "sampler", picture);
  }
}

void addMaterials(Table& table) {
  for (const std::string_view name : materialNames()) {
    table.add("megakernel.material", "material", basicPicture(std::string(name)));
  }
}

void addWorkgroups(Table& table) {
  for (const auto& [name, size] : kWorkgroups) {
    Picture picture = basicPicture();
    picture.request.execution.workgroup = size;
    table.add(fmt::format("megakernel.workgroup.{}", name), "workgroup", picture);
  }
}

void addSubgroups(Table& table) {
  for (const std::uint32_t size : kSubgroupSizes) {
    Picture picture = basicPicture();
    picture.subgroupSize = size;
    table.add(fmt::format("megakernel.subgroup.{}", size), "workgroup", picture);
  }
}

}  // namespace

Cases pictureCases(const PictureTest& test) {
  Table table(test);
  addSequences(table);
  addStructures(table);
  addScenes(table);
  addIntegrators(table);
  addSamplers(table);
  addMaterials(table);
  addWorkgroups(table);
  addSubgroups(table);
  return table.take();
}

}  // namespace candela::conformance
