// Limits of control groups, in folders that stand in for those of the kernel.
#include "host/base/memory_limit.h"

#include <catch2/catch.hpp>

#include "tests/base/temporary_folder.h"

using namespace candela;

namespace {

// The limit of a process with these memberships, among groups whose limits are written by `write`.
struct Groups {
  const TemporaryFolder folder;

  void write(const std::string& group, const std::string& file, const std::string& limit) const {
    std::filesystem::create_directories(folder.path() / "groups" / group);
    writeText(folder.path() / "groups" / group / file, limit + "\n");
  }
  std::optional<std::uint64_t> limitOf(const std::string& membership) const {
    writeText(folder.path() / "membership", membership);
    return controlGroupMemory(folder.path() / "membership", folder.path() / "groups");
  }
};

}  // namespace

TEST_CASE("the smallest limit of a control group and of those above it counts") {
  const Groups groups;
  groups.write("slurm", "memory.max", "3000");
  groups.write("slurm/job", "memory.max", "max");
  groups.write("slurm/job/task", "memory.max", "4000");
  groups.write("other", "memory.max", "1");
  CHECK(groups.limitOf("0::/slurm/job/task\n") == 3000);
  CHECK(groups.limitOf("0::/slurm/job\n") == 3000);
  CHECK(groups.limitOf("0::/other\n") == 1);
  CHECK(groups.limitOf("0::/\n") == std::nullopt);
}

TEST_CASE("in a container, the group of the process may be the root of the hierarchy") {
  const Groups groups;
  groups.write("", "memory.max", "5000");
  groups.write("memory", "memory.limit_in_bytes", "6000");
  CHECK(groups.limitOf("0::/\n") == 5000);
  CHECK(groups.limitOf("0::/../../elsewhere\n") == 5000);
  CHECK(groups.limitOf("4:memory:/docker/abc\n") == 6000);
}

TEST_CASE("limits of both versions of control groups are read") {
  const Groups groups;
  groups.write("memory/a", "memory.limit_in_bytes", "7000");
  groups.write("b", "memory.max", "8000");
  CHECK(groups.limitOf("5:cpu,memory:/a\n1:name=systemd:/b\n0::/b\n") == 7000);
  CHECK(groups.limitOf("5:cpu:/a\n") == std::nullopt);
  CHECK(groups.limitOf("not a list") == std::nullopt);
}

TEST_CASE("a machine without control groups has no limit") {
  CHECK(controlGroupMemory("/nonexistent/cgroup", "/nonexistent") == std::nullopt);
}
