// Queries the Vulkan loader.
#include "host/trace/vulkan/loader_info.h"

#include <fmt/format.h>

#include "host/trace/vulkan/instance.h"
#include "host/trace/vulkan/vulkan_errors.h"

namespace candela::vulkan {

std::optional<LoaderInfo> findLoader() {
  const std::optional<vk::raii::Context> context = openLoader();
  if (!context) return std::nullopt;
  return guarded("query the Vulkan loader", [&]() -> LoaderInfo {
    const std::uint32_t version = context->enumerateInstanceVersion();
    return {fmt::format("{}.{}.{}", VK_API_VERSION_MAJOR(version), VK_API_VERSION_MINOR(version),
                        VK_API_VERSION_PATCH(version)),
            hasValidationLayer(*context)};
  });
}

}  // namespace candela::vulkan
