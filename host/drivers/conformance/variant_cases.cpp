// The table of variants: kernels, and the modules of the other cases.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "host/drivers/conformance/case_tables.h"
#include "host/drivers/conformance/picture_run.h"
#include "host/drivers/conformance/scenes.h"
#include "host/drivers/conformance/variant_capture.h"
#include "host/drivers/conformance/variant_question.h"
#include "host/drivers/conformance/variant_shrink.h"
#include "host/drivers/conformance/workbench.h"

namespace candela::conformance {
namespace {

using render::Integrator;
using render::KernelKind;
using variants::Variant;

constexpr std::uint32_t kVariantSide = 24, kVariantSamples = 8, kVariantDepth = 5;

struct KernelRow {
  const char* name;
  Integrator integrator;
  KernelKind kernel;
  std::vector<const char*> scenes;  ///< the verdict judges the first
};

const std::array kKernelRows{
    KernelRow{"path", Integrator::path, KernelKind::megakernel, {"cornell", "primitives", "terrain"}},
    KernelRow{"wavefront", Integrator::path, KernelKind::wavefront, {"cornell", "primitives"}},
    KernelRow{"whitted", Integrator::whitted, KernelKind::megakernel, {"primitives"}},
    KernelRow{"views", Integrator::ao, KernelKind::megakernel, {"primitives"}}};

Picture pictureOf(const KernelRow& row, const std::string& scene) {
  Picture picture{.scene = scene};
  picture.request.size = render::Extent{kVariantSide, kVariantSide};
  picture.request.sampleCount = kVariantSamples;
  picture.request.accel = render::AccelKind::bvh;
  picture.request.image.integrator = row.integrator;
  if (row.integrator == Integrator::whitted) picture.request.maxDepth = kVariantDepth;
  picture.request.execution.threads = 1;
  picture.request.execution.kernel = row.kernel;
  picture.request.structure.bvhLayout = render::BvhLayout::cwbvh;
  return picture;
}

Observation observeFilm(const Picture& picture, Workbench& workbench) {
  image::Film film = workbench.renderer().render(sceneNamed(picture.scene), picture.settings(), {}).film;
  return {fmt::format("film {:016x}", film.hash()), {}, std::move(film)};
}

Observation observeFinding(const Finding& finding) {
  if (finding.outcome == Outcome::skip) return {std::string(kSkipped), finding.text};
  return {finding.outcome == Outcome::pass ? "Pass" : "Fail", finding.text};
}

using Compile = std::function<Finding(Workbench&)>;

Finding compileForm(const Compile& compile, const Variant& variant, const Workbench& workbench) {
  Workbench form(workbench.info(), {.prepareShader = variants::preparation(variant), .compilesOnly = true});
  return compile(form);
}

using CaptureVariant = std::function<capture::Capture(const Variant&, const vulkan::DeviceInfo&)>;

Case caseOf(const std::string& name, const VariantQuestion& question, const Compile& compile,
            const CaptureVariant& capture) {
  return {name,
          question.group,
          [question](Workbench& bench) { return compareForms(question, bench); },
          [compile, variant = question.variant](Workbench& bench) { return compileForm(compile, variant, bench); },
          [=](const vulkan::DeviceInfo& device) { return capture(question.variant, device); },
          [question](const vulkan::DeviceInfo& device, const ShrinkLimits& limits) {
            return smallestDifference(question, device, limits);
          }};
}

void addFilms(const KernelRow& row, Cases& cases) {
  for (const char* const scene : row.scenes) {
    const Picture picture = pictureOf(row, scene);
    for (const Variant& variant : variants::allVariants()) {
      cases.push_back(caseOf(fmt::format("variants.{}.{}.{}", row.name, variant.name, scene),
                             {fmt::format("variants.{}.{}", row.name, scene), variant,
                              [picture](Workbench& bench) { return observeFilm(picture, bench); }},
                             std::bind_front(compilePicture, picture), std::bind_front(captureForms, picture)));
    }
  }
}

// Specialisation constants change no rounding, so that the verdict judges only the other variants.
void addVerdicts(const KernelRow& row, Cases& cases) {
  const Picture picture = pictureOf(row, row.scenes.front());
  for (const Variant& variant : variants::allVariants()) {
    if (variant.steps.empty()) continue;
    cases.push_back(caseOf(fmt::format("variants.{}.{}_undecorated.{}", row.name, variant.name, picture.scene),
                           {fmt::format("variants.{}.undecorated", row.name), withContraction(variant),
                            [picture](Workbench& bench) { return observeFinding(comparePicture(picture, bench)); }},
                           std::bind_front(compilePicture, picture), std::bind_front(captureVerdict, picture)));
  }
}

// Accesses beyond the end of a buffer may differ between variants, and a copy has no module.
bool hasForms(const Case& one) {
  return one.name.rfind("memory.robust.", 0) != 0 && one.name.rfind("memory.command.", 0) != 0;
}

void addModules(const Cases& table, Cases& cases) {
  for (const Case& one : table) {
    if (!hasForms(one)) continue;
    for (const Variant& variant : variants::allVariants()) {
      cases.push_back(caseOf(fmt::format("variants.module.{}.{}", variant.name, one.name),
                             {"variants.module." + one.name, variant,
                              [run = one.run](Workbench& bench) { return observeFinding(run(bench)); }},
                             one.compile, std::bind_front(captureModule, one)));
    }
  }
}

}  // namespace

Cases variantCases() {
  Cases cases;
  for (const KernelRow& row : kKernelRows) {
    addFilms(row, cases);
    addVerdicts(row, cases);
  }
  for (const Cases& table :
       {integerCases(), floatCases(), functionCases(), controlCases(), memoryCases(), groupCases()}) {
    addModules(table, cases);
  }
  return cases;
}

}  // namespace candela::conformance
