// Device files of GPUs, in a folder that replaces /dev.
#include "host/drivers/doctor/gpu_nodes.h"

#include <catch2/catch.hpp>

#include "tests/base/temporary_folder.h"

namespace candela::doctor {

TEST_CASE("a GPU that no Vulkan driver lists, or that cannot be opened, is a warning") {
  const TemporaryFolder folder;
  CHECK(checkGpuNodes(folder.path(), false).empty());
  std::filesystem::create_directories(folder / "dri");
  writeText(folder.path() / "dri" / "card0", "");
  writeText(folder.path() / "dri" / "renderD128", "");
  CHECK(checkGpuNodes(folder.path(), true).at(0).status == Status::ok);
  const Checks unlisted = checkGpuNodes(folder.path(), false);
  REQUIRE(unlisted.size() == 1);
  CHECK(unlisted[0].name == "GPU renderD128");
  CHECK(unlisted[0].status == Status::warning);
  CHECK_THAT(unlisted[0].remedy, Catch::Contains("mesa-vulkan-drivers"));
  // Permissions do not apply to root, but nobody can open a link to nothing.
  std::filesystem::create_symlink("nothing", folder / "nvidiactl");
  const Checks closed = checkGpuNodes(folder.path(), true);
  REQUIRE(closed.size() == 2);
  CHECK(closed[1].status == Status::warning);
  CHECK_THAT(closed[1].text, Catch::Contains("cannot be opened: No such file"));
  CHECK_FALSE(closed[1].remedy.empty());
}

}  // namespace candela::doctor
