// Finds GPUs that the kernel lists but no Vulkan driver supports.
#include "host/drivers/doctor/gpu_nodes.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>

namespace candela::doctor {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> filesBeginningWith(const fs::path& folder, const std::string& prefix) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    if (entry->path().filename().string().starts_with(prefix)) files.push_back(entry->path());
  }
  std::ranges::sort(files);
  return files;
}

Check checkNode(const fs::path& node, bool gpuListed) {
  Check check{fmt::format("GPU {}", node.filename().string()), Status::ok, "accessible", ""};
  if (::access(node.c_str(), R_OK | W_OK) != 0) {
    check.status = Status::warning;
    check.text = fmt::format("{} cannot be opened: {}", node.string(), std::strerror(errno));
    check.remedy = "usermod -aG render,video $USER, and log in again";
  } else if (!gpuListed) {
    check.status = Status::warning;
    check.text = fmt::format("{} exists, but no Vulkan driver lists a GPU", node.string());
    check.remedy =
        "install the GPU's driver: mesa-vulkan-drivers (AMD, Intel) or nvidia-driver, which need a recent kernel";
  }
  return check;
}

}  // namespace

Checks checkGpuNodes(const fs::path& folder, bool gpuListed) {
  std::vector<fs::path> nodes = filesBeginningWith(folder / "dri", "renderD");
  for (const fs::path& node : filesBeginningWith(folder, "nvidiactl")) nodes.push_back(node);
  Checks checks;
  for (const fs::path& node : nodes) checks.push_back(checkNode(node, gpuListed));
  return checks;
}

}  // namespace candela::doctor
