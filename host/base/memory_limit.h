// The limit of memory of the control groups (cgroups) in which containers and schedulers run programs.
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>

namespace candela {

/// Returns the smallest limit in bytes of the control groups that contain this process, of version 1 or 2; nothing if
/// none has a limit. `membership` is a file in the format of /proc/PID/cgroup, and `root` the folder in which the
/// hierarchies are mounted. Source: cgroups(7).
std::optional<std::uint64_t> controlGroupMemory(const std::filesystem::path& membership = "/proc/self/cgroup",
                                                const std::filesystem::path& root = "/sys/fs/cgroup");

}  // namespace candela
