// Files and pipes that are read as a whole.
#include "host/base/input_file.h"

#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <fstream>
#include <thread>

#include "host/base/errors.h"
#include "tests/base/temporary_folder.h"

namespace candela {
namespace {

constexpr std::size_t kMaxBytes = 1 << 20;

std::string read(const std::filesystem::path& file) {
  return readInputFile(file, kMaxBytes, InputKind::regularFileOrPipe);
}

}  // namespace

TEST_CASE("a pipe is read from its first byte to its end, even if it is opened before its writer") {
  const TemporaryFolder folder;
  const std::filesystem::path pipe = folder / "pipe";
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  std::jthread writer([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));  // the reader is there first, or as late as it likes
    std::ofstream(pipe) << "a scene " << std::flush << "in two parts";
  });
  CHECK(read(pipe) == "a scene in two parts");
}

TEST_CASE("a file that is too large, missing, a folder or a pipe is refused by name") {
  const TemporaryFolder folder;
  folder.write("large", std::string(kMaxBytes + 1, 'x'));
  CHECK_THROWS_WITH(read(folder / "large"), Catch::Contains("large: larger than 1 MiB"));
  CHECK_THROWS_WITH(read(folder / "none"), Catch::Contains("none: cannot open"));
  CHECK_THROWS_WITH(read(folder.path()), Catch::Contains("is a folder"));
  REQUIRE(::mkfifo((folder / "pipe").c_str(), 0600) == 0);
  CHECK_THROWS_AS(readInputFile(folder / "pipe", kMaxBytes, InputKind::regularFile), FileError);
}

}  // namespace candela
