// The folders to which captures may be written; captures appear completely or not at all.
#include "host/drivers/capture/folder.h"

#include <catch2/catch.hpp>
#include <filesystem>

#include "host/base/errors.h"
#include "tests/app/cli/run_program.h"

namespace candela::capture {
namespace {

namespace fs = std::filesystem;

Capture smallCapture() {
  vulkan::Recording recording;
  recording.shaders.push_back({{1, 2, 3}, {.bindings = {vulkan::BindingKind::storageBuffer}}});
  recording.buffers.push_back({16, vulkan::Usage::storage});
  recording.commands.emplace_back(vulkan::RecordedDispatch{0, {0}, {}, {}, {}});
  Capture capture = cutDown(recording);
  capture.title = "small";
  capture.differing = 40;
  capture.expected.push_back({ValueType::word, {0, 1}, 5, 5});
  capture.files.push_back({"scene.p3f", "l 0 0 0\n"});
  return capture;
}

}  // namespace

TEST_CASE("A capture is written to a new folder, or to an empty one") {
  const TemporaryFolder folder;
  fs::create_directory(folder.path("empty"));
  for (const char* const name : {"new", "empty", "slash/"}) {
    writeFolder(smallCapture(), folder.path(name));
    CHECK(fs::file_size(folder.path(name) + "/module_0.spv") == 12);
    CHECK(fs::file_size(folder.path(name) + "/expected.bin") == 32);
    CHECK(readText(folder.path(name) + "/minimum.txt") == "10\n");
    CHECK(readText(folder.path(name) + "/scene.p3f") == "l 0 0 0\n");
    CHECK_FALSE(fs::exists(folder.path(name) + "/buffer_0.bin"));
    for (const std::string script : {"/interesting.sh", "/reduce.sh"}) {
      CHECK((fs::status(folder.path(name) + script).permissions() & fs::perms::owner_exec) != fs::perms::none);
    }
  }
  CHECK(folder.fileCount() == 3);
}

TEST_CASE("The README states the values after the reduction, and their number before it") {
  const TemporaryFolder folder;
  Capture capture = smallCapture();
  capture.expectedBy = "the host";
  writeFolder(capture, folder.path("whole"));
  const std::string whole = readText(folder.path("whole/README.md"));
  CHECK_THAT(whole, Catch::Contains("It compares 1 value of the result with those that the host computed. It was"));
  capture.wholeCount = 32;
  writeFolder(capture, folder.path("reduced"));
  CHECK_THAT(readText(folder.path("reduced/README.md")),
             Catch::Contains("the host computed. They were reduced from 32 values. It was"));
}

TEST_CASE("A folder with files, a file and a folder in no folder are refused") {
  const TemporaryFolder folder;
  fs::create_directory(folder.path("full"));
  folder.write("full/a", "a");
  folder.write("file", "a");
  CHECK_THROWS_WITH(requireNewFolder(folder.path("full")), Catch::Contains("the folder has files"));
  CHECK_THROWS_WITH(requireNewFolder(folder.path("file")), Catch::Contains("is a file"));
  CHECK_THROWS_WITH(requireNewFolder(folder.path("none/new")), Catch::Contains("there is no folder"));
  CHECK_THROWS_AS(writeFolder(smallCapture(), folder.path("full")), FileError);
  CHECK(readText(folder.path("full/a")) == "a");
}

TEST_CASE("A capture that cannot be written leaves no files") {
  const TemporaryFolder folder;
  Capture capture = smallCapture();
  capture.files.push_back({"no/such/folder", "text"});
  CHECK_THROWS_AS(writeFolder(capture, folder.path("new")), FileError);
  CHECK(folder.fileCount() == 0);
}

}  // namespace candela::capture
