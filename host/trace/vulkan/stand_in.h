// Recognises devices without hardware behind them.
#pragma once
#include <string>
#include <vector>

namespace candela::vulkan {

/// Returns what stands in for the hardware of a GPU with this name, as Mesa's libraries *_noop_drm_shim.so and its null
/// hardware do, which execute nothing; empty if the device may be real. `libraries` are those of the process.
std::string standInFor(const std::string& deviceName, const std::vector<std::string>& libraries);

/// Returns the files of the libraries that this process has loaded.
std::vector<std::string> loadedLibraries();

}  // namespace candela::vulkan
