// The report of `candela kernels`: what a driver makes of the kernels of scenes.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "host/drivers/kernels/figures.h"
#include "host/trace/vulkan/device_info.h"

namespace candela::kernels {

/// A kernel with the settings for which it was compiled.
struct KernelRow {
  std::string scene;
  std::string sceneHash;
  std::string kernel;  ///< such as "megakernel" or "wavefront.shade"
  std::string workgroup;
  std::string structure;
  std::string layout;  ///< empty: it has none
  std::string sceneLoads;
  Figures figures;
  std::vector<vulkan::Executable> executables;
};

struct KernelReport {
  vulkan::DeviceInfo device;
  std::vector<KernelRow> rows;

  /// Returns whether the driver reports statistics of any kernel.
  bool hasStatistics() const;
};

inline constexpr const char* kKernelsSchema = "candela-kernels/1";

/// Returns a value as it stands in tables; empty if there is none.
std::string figureText(const FigureInfo& figure, const std::optional<double>& value);

std::string toText(const KernelReport& report);
std::string toMarkdown(const KernelReport& report);
nlohmann::ordered_json toJson(const KernelReport& report);

}  // namespace candela::kernels
