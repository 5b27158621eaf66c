// Reads the limits of a group and of all groups above it.
#include "host/base/memory_limit.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>

namespace candela {
namespace {

namespace fs = std::filesystem;

// Returns nothing for "max", which stands for no limit, and for a file that does not exist.
std::optional<std::uint64_t> limitIn(const fs::path& file) {
  std::ifstream stream(file);
  std::uint64_t bytes = 0;
  return stream >> bytes ? std::optional(bytes) : std::nullopt;
}

// Inside a container, the hierarchy may be mounted from its own group on, so that the folder of `group` does not exist
// and `root` has the limit.
std::optional<std::uint64_t> smallestLimit(const fs::path& root, const std::string& group, const char* file) {
  std::optional<std::uint64_t> smallest = limitIn(root / file);
  fs::path folder = root;
  for (const fs::path& name : fs::path(group).lexically_normal().relative_path()) {
    folder /= name;
    const std::optional<std::uint64_t> own = limitIn(folder / file);
    if (own) smallest = std::min(smallest.value_or(*own), *own);
  }
  return smallest;
}

bool hasMemory(const std::string& controllers) {
  std::istringstream list(controllers);
  for (std::string name; std::getline(list, name, ',');) {
    if (name == "memory") return true;
  }
  return false;
}

}  // namespace

std::optional<std::uint64_t> controlGroupMemory(const fs::path& membership, const fs::path& root) {
  std::optional<std::uint64_t> smallest;
  std::ifstream groups(membership);
  for (std::string id, controllers, group;
       std::getline(groups, id, ':') && std::getline(groups, controllers, ':') && std::getline(groups, group);) {
    std::optional<std::uint64_t> groupLimit;
    if (controllers.empty()) groupLimit = smallestLimit(root, group, "memory.max");
    if (hasMemory(controllers)) groupLimit = smallestLimit(root / "memory", group, "memory.limit_in_bytes");
    if (groupLimit) smallest = std::min(smallest.value_or(*groupLimit), *groupLimit);
  }
  return smallest;
}

}  // namespace candela
