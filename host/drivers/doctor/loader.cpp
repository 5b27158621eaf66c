// Examines the Vulkan loader and the validation layer.
#include "host/drivers/doctor/loader.h"

#include "host/trace/vulkan/loader_info.h"
#include "host/trace/vulkan/validation.h"

namespace candela::doctor {
namespace {

Check checkValidation(bool installed) {
  const bool requested = vulkan::validationRequested();
  Check check{"validation layer", Status::ok, "", ""};
  if (installed) {
    check.text = requested ? "installed, and on (CANDELA_VALIDATION)" : "installed; CANDELA_VALIDATION=1 turns it on";
  } else if (requested) {
    check = {"validation layer", Status::problem, "CANDELA_VALIDATION requests it, but it is not installed",
             "apt-get install vulkan-validationlayers, or unset CANDELA_VALIDATION"};
  } else {
    check.text = "not installed; only tests of Candela need it";
  }
  return check;
}

}  // namespace

Checks checkLoader() {
  const std::optional<vulkan::LoaderInfo> loader = vulkan::findLoader();
  if (!loader) {
    return {{"Vulkan loader", Status::problem, "libvulkan.so.1 cannot be opened",
             "apt-get install libvulkan1 mesa-vulkan-drivers"}};
  }
  return {{"Vulkan loader", Status::ok, "version " + loader->version, ""}, checkValidation(loader->hasValidation)};
}

}  // namespace candela::doctor
