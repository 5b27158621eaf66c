// Recognises Mesa's stand-ins for hardware.
#include "host/trace/vulkan/stand_in.h"

#include <link.h>

#include <filesystem>

namespace candela::vulkan {

std::string standInFor(const std::string& deviceName, const std::vector<std::string>& libraries) {
  if (deviceName.starts_with("Null hardware")) return "RADV_FORCE_FAMILY";
  for (const std::string& library : libraries) {
    if (library.ends_with("_noop_drm_shim.so")) return std::filesystem::path(library).filename().string();
  }
  return "";
}

std::vector<std::string> loadedLibraries() {
  std::vector<std::string> libraries;
  ::dl_iterate_phdr(
      [](dl_phdr_info* info, std::size_t, void* data) {
        static_cast<std::vector<std::string>*>(data)->emplace_back(info->dlpi_name);
        return 0;
      },
      &libraries);
  return libraries;
}

}  // namespace candela::vulkan
