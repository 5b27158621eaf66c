// Observes variants of kernels.
#include "host/drivers/conformance/variant_question.h"

#include <algorithm>
#include <array>

#include "host/drivers/conformance/workbench.h"

namespace candela::conformance {
namespace {

// Probes are not changed: they measure the device, and their results divide the work and read the scene in the same way
// for all variants.
constexpr std::array<std::string_view, 2> kProbes{"loop_probe", "loads_probe"};

// Returns the observation of the plain form, which the first case of the group makes. An exception leaves no
// observation, so that the next case makes it again.
const Observation& plainObservation(const VariantQuestion& question, Workbench& workbench) {
  std::map<std::string, Observation>& known = workbench.observations();
  if (const auto found = known.find(question.group); found != known.end()) return found->second;
  Observation plain = observeForm(question, plainFormOf(question), workbench.info());
  return known.emplace(question.group, std::move(plain)).first->second;
}

}  // namespace

variants::Variant plainFormOf(const VariantQuestion& question) {
  return question.variant.forbidsContraction ? variants::plainVariant()
                                             : variants::withContraction(variants::plainVariant());
}

Observation observeForm(const VariantQuestion& question, const variants::Variant& form,
                        const vulkan::DeviceInfo& device, const variants::PreparationScope& scope) {
  variants::PreparationScope withoutProbe = scope;
  withoutProbe.isMeant = [isMeant = scope.isMeant](std::span<const std::uint32_t> spirv) {
    return std::ranges::count(kProbes, moduleName(spirv)) == 0 && (!isMeant || isMeant(spirv));
  };
  Workbench workbench(device, {.prepareShader = variants::preparation(form, withoutProbe)});
  return question.observe(workbench);
}

Finding compareForms(const VariantQuestion& question, Workbench& workbench) {
  const Observation& plain = plainObservation(question, workbench);
  if (plain.key == kSkipped) return skipped(plain.text);
  const Observation other = observeForm(question, question.variant, workbench.info());
  const std::string difference = differenceBetween(plain, other, question.variant.name);
  return difference.empty() ? passed() : failed(difference);
}

}  // namespace candela::conformance
