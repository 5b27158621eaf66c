// The installed Vulkan loader; this header uses no Vulkan type.
#pragma once
#include <optional>
#include <string>

namespace candela::vulkan {

struct LoaderInfo {
  std::string version;         ///< highest Vulkan version of its instances, e.g. "1.3.239"
  bool hasValidation = false;  ///< the Khronos validation layer is installed
};

/// Opens the loader, but no driver. Returns nothing if there is no loader.
std::optional<LoaderInfo> findLoader();

}  // namespace candela::vulkan
