// Observes variants of kernels.
#include "host/conformance/variant_question.h"

#include "host/conformance/workbench.h"

namespace candela::conformance {
namespace {

// The probe of the loop limit is not changed: it measures the device, and its result divides the work in the same
// way for all variants.
constexpr std::string_view kProbe = "loop_probe";

}  // namespace

variants::Variant plainFormOf(const VariantQuestion& question) {
  return question.variant.forbidsContraction ? variants::plainVariant()
                                             : variants::withContraction(variants::plainVariant());
}

Observation observeForm(const VariantQuestion& question, const variants::Variant& form,
                        const vulkan::DeviceInfo& device, const variants::PreparationScope& scope) {
  variants::PreparationScope withoutProbe = scope;
  withoutProbe.isMeant = [isMeant = scope.isMeant](std::span<const std::uint32_t> spirv) {
    return moduleName(spirv) != kProbe && (!isMeant || isMeant(spirv));
  };
  Workbench workbench(device, {}, variants::preparation(form, withoutProbe));
  return question.observe(workbench);
}

Finding compareForms(const VariantQuestion& question, Workbench& workbench) {
  const auto [plain, isNew] = workbench.observations().try_emplace(question.group);
  if (isNew) plain->second = observeForm(question, plainFormOf(question), workbench.info());
  if (plain->second.key == kSkipped) return skipped(plain->second.text);
  const Observation other = observeForm(question, question.variant, workbench.info());
  const std::string difference = differenceBetween(plain->second, other, question.variant.name);
  return difference.empty() ? passed() : failed(difference);
}

}  // namespace candela::conformance
