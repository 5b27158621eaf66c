// Files of compiled pipelines: a written file is read again, and any other content is refused.
#include "host/job/cache/pipeline_file.h"

#include <sys/stat.h>

#include <catch2/catch.hpp>

#include "host/base/errors.h"
#include "tests/base/temporary_folder.h"

namespace candela::cache {
namespace {

namespace fs = std::filesystem;

const DeviceKey kKey{"a device", "a driver", "17", "0123", "abcd"};

std::vector<std::byte> someData() {
  std::vector<std::byte> data;
  for (int i = 0; i < 1000; ++i) data.push_back(static_cast<std::byte>(i * i));
  return data;
}

}  // namespace

TEST_CASE("stored pipelines are read as they were written, and replace earlier ones") {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "new" / "pipelines.bin";
  writePipelines(file, kKey, {});
  CHECK(readPipelines(file, kKey).data.empty());
  CHECK(readPipelines(file, kKey).problem.empty());
  writePipelines(file, kKey, someData());
  const PipelineLookup found = readPipelines(file, kKey);
  CHECK(found.problem.empty());
  CHECK(found.data == someData());
}

TEST_CASE("a missing file of pipelines is no problem") {
  const TemporaryFolder folder;
  CHECK(readPipelines(folder / "none.bin", kKey).problem.empty());
  CHECK(readPipelines(folder.path() / "none" / "none.bin", kKey).problem.empty());
}

TEST_CASE("pipelines of another device, driver or set of kernels are refused") {
  const TemporaryFolder folder;
  writePipelines(folder / "a.bin", kKey, someData());
  for (std::string DeviceKey::*member : {&DeviceKey::device, &DeviceKey::driver, &DeviceKey::driverVersion,
                                         &DeviceKey::pipelineCacheUuid, &DeviceKey::kernels}) {
    DeviceKey other = kKey;
    other.*member += "'";
    const PipelineLookup found = readPipelines(folder / "a.bin", other);
    CHECK(found.data.empty());
    CHECK_THAT(found.problem, Catch::Contains("another device, driver or set of kernels"));
  }
}

TEST_CASE("a file of pipelines that is truncated anywhere or has one wrong byte is refused") {
  const TemporaryFolder folder;
  writePipelines(folder / "a.bin", kKey, someData());
  const std::string sound = readText(folder / "a.bin");
  for (std::size_t i = 0; i < sound.size(); ++i) {
    writeText(folder / "b.bin", sound.substr(0, i));
    CHECK_FALSE(readPipelines(folder / "b.bin", kKey).problem.empty());
    std::string changed = sound;
    changed[i] = static_cast<char>(changed[i] ^ 0x10);
    writeText(folder / "b.bin", changed);
    const PipelineLookup found = readPipelines(folder / "b.bin", kKey);
    CHECK_FALSE(found.problem.empty());
    CHECK(found.data.empty());
  }
}

TEST_CASE("devices, pipes and folders are not read as files of pipelines") {
  const TemporaryFolder folder;
  REQUIRE(::mkfifo((folder / "pipe").c_str(), 0600) == 0);
  CHECK(readPipelines(folder / "pipe", kKey).problem == "not a regular file");
  CHECK(readPipelines("/dev/zero", kKey).problem == "not a regular file");
  CHECK(readPipelines(folder.path(), kKey).problem == "not a regular file");
}

TEST_CASE("pipelines cannot be stored if a file is in the place of the folder") {
  const TemporaryFolder folder;
  writeText(folder / "file", "");
  CHECK_THROWS_AS(writePipelines(folder.path() / "file" / "a.bin", kKey, someData()), FileError);
}

}  // namespace candela::cache
