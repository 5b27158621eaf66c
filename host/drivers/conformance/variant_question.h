// A variant of a kernel that must compute the same as the plain form.
#pragma once
#include <functional>
#include <memory>

#include "host/drivers/conformance/case.h"
#include "host/drivers/conformance/observation.h"
#include "host/drivers/variants/variant.h"

namespace candela::conformance {

struct VariantQuestion {
  std::string group;  ///< questions of one group have the same plain form and observation
  variants::Variant variant;
  std::function<Observation(Workbench&)> observe;
};

/// Observes the plain form and the variant on the device of the workbench, and compares them.
Finding compareForms(const VariantQuestion& question, Workbench& workbench);

/// Observes a form on a device.
Observation observeForm(const VariantQuestion& question, const variants::Variant& form,
                        const vulkan::DeviceInfo& device, const variants::PreparationScope& scope = {});

/// Returns the form with which the variant is compared.
variants::Variant plainFormOf(const VariantQuestion& question);

/// Returns the name of a module of the program, e.g. "wave_shade".
std::string moduleName(std::span<const std::uint32_t> spirv);

}  // namespace candela::conformance
