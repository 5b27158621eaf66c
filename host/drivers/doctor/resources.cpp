// Examines memory and disk space.
#include "host/drivers/doctor/resources.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <optional>
#include <system_error>

#include "host/base/memory_budget.h"

namespace candela::doctor {
namespace {

namespace fs = std::filesystem;

constexpr double kGiB = 1024.0 * 1024 * 1024;
// A film of 1920 x 1080 pixels takes some 130 MB, on the host and on the device.
constexpr double kMinMemory = 0.5 * kGiB;
constexpr double kMinDisk = 0.25 * kGiB;

// Linux's estimate of the memory that programs can get without swapping.
std::optional<double> availableMemory() {
  std::ifstream file("/proc/meminfo");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("MemAvailable:")) return 1024 * std::stod(line.substr(line.find(':') + 1));
  }
  return std::nullopt;
}

Check checkMemory() {
  const auto total = static_cast<double>(memoryBudget());
  const double available = std::min(availableMemory().value_or(total), total);
  Check check{"memory", Status::ok, fmt::format("{:.1f} of {:.1f} GiB available", available / kGiB, total / kGiB), ""};
  if (memoryBudget() < physicalMemory())
    check.text += "; the control group of this process (a container or a scheduler) sets this limit";
  if (available < kMinMemory) {
    check.status = Status::warning;
    check.remedy = "close other programs, or render smaller pictures";
  }
  return check;
}

Check checkDisk(const fs::path& folder) {
  if (folder.empty()) {
    return {"working folder", Status::warning, "it was removed, so that files with relative names cannot be written",
            "change to another folder"};
  }
  const std::string name = folder.string();
  if (const std::string problem = whyNotWritable(folder); !problem.empty()) {
    return {"working folder", Status::warning, fmt::format("{} cannot be written: {}", name, problem),
            "write pictures into another folder (-o)"};
  }
  std::error_code error;
  const fs::space_info space = fs::space(folder, error);
  if (error) return {"working folder", Status::ok, name + " is writable", ""};
  const double available = static_cast<double>(space.available);
  Check check{"working folder", Status::ok, fmt::format("{} is writable, {:.1f} GiB free", name, available / kGiB), ""};
  if (available < kMinDisk) {
    check.status = Status::warning;
    check.remedy = "free space on this disk, or write pictures to another one (-o)";
  }
  return check;
}

// Creates a file and removes it. Permissions alone do not show what file systems such as /proc refuse.
std::string whyNoFile(const fs::path& folder) {
  std::string name = (folder / "candela-XXXXXX").string();
  const int file = ::mkstemp(name.data());
  if (file < 0) return fmt::format("no file can be created in {}: {}", folder.string(), std::strerror(errno));
  ::close(file);
  ::unlink(name.c_str());
  return "";
}

}  // namespace

std::string whyNotWritable(const fs::path& folder) {
  std::error_code error;
  fs::path existing = fs::absolute(folder, error);
  while (!fs::exists(fs::symlink_status(existing, error)) && existing.has_relative_path()) {
    existing = existing.parent_path();
  }
  if (!fs::is_directory(existing, error)) return existing.string() + " is not a folder";
  return whyNoFile(existing);
}

Checks checkResources(const fs::path& folder) { return {checkMemory(), checkDisk(folder)}; }

}  // namespace candela::doctor
