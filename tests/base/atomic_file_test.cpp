// Files that exist completely or not at all.
#include "host/base/atomic_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <catch2/catch.hpp>

#include "host/base/errors.h"
#include "tests/base/temporary_folder.h"

using namespace candela;
namespace fs = std::filesystem;

namespace {

std::size_t fileCount(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

}  // namespace

TEST_CASE("an atomic write creates and replaces a file and leaves no temporary file") {
  TemporaryFolder folder;
  writeFileAtomically(folder / "a.txt", toBytes("first"));
  CHECK(readText(folder / "a.txt") == "first");
  writeFileAtomically(folder / "a.txt", toBytes("2"));
  CHECK(readText(folder / "a.txt") == "2");
  writeFileAtomically(folder / "empty", {});
  CHECK(fs::file_size(folder / "empty") == 0);
  CHECK(fileCount(folder.path()) == 2);
}

TEST_CASE("a file with a relative name is written atomically") {
  TemporaryFolder folder;
  const fs::path before = fs::current_path();
  fs::current_path(folder.path());
  writeFileAtomically("plain", toBytes("x"));
  fs::current_path(before);
  CHECK(readText(folder / "plain") == "x");
}

TEST_CASE("an atomic write that fails names the file and leaves no trace") {
  TemporaryFolder folder;
  CHECK_THROWS_WITH(writeFileAtomically(folder / "no/such/folder", toBytes("x")),
                    Catch::Contains("no/such/folder") && Catch::Contains("No such file or directory"));
  fs::create_directory(folder / "directory");
  writeText(folder / "directory/inside", "x");
  CHECK_THROWS_AS(writeFileAtomically(folder / "directory", toBytes("x")), FileError);
  CHECK(fileCount(folder.path()) == 1);
}

TEST_CASE("a name that is too long for the temporary file is refused before anything is written") {
  const TemporaryFolder folder;
  constexpr std::size_t kLongest = 255 - std::string_view(".candela-part").size();
  writeFileAtomically(folder.path(std::string(kLongest, 'n')), {});
  CHECK_THROWS_WITH(AtomicFile(folder.path(std::string(kLongest + 1, 'n'))), Catch::Contains("File name too long"));
  CHECK(folder.fileCount() == 1);
}

TEST_CASE("an atomic write follows a symbolic link and preserves it") {
  TemporaryFolder folder;
  writeText(folder / "target", "old");
  fs::create_symlink("target", folder / "link");
  writeFileAtomically(folder / "link", toBytes("new"));
  CHECK(fs::is_symlink(folder / "link"));
  CHECK(readText(folder / "target") == "new");
}

TEST_CASE("an atomic write never replaces a device or a pipe") {
  writeFileAtomically("/dev/null", toBytes("gone"));
  CHECK(fs::is_character_file("/dev/null"));

  TemporaryFolder folder;
  REQUIRE(::mkfifo((folder / "pipe").c_str(), 0600) == 0);
  CHECK_THROWS_AS(writeFileAtomically(folder / "pipe", toBytes("to nobody")), FileError);
  const int reader = ::open((folder / "pipe").c_str(), O_RDONLY | O_NONBLOCK);
  REQUIRE(reader >= 0);
  writeFileAtomically(folder / "pipe", toBytes("through"));
  char text[16]{};
  CHECK(::read(reader, text, sizeof text) == 7);
  CHECK(std::string(text) == "through");
  ::close(reader);
  CHECK(fs::is_fifo(folder / "pipe"));
}

TEST_CASE("an atomic write preserves the permissions of the file that it replaces") {
  TemporaryFolder folder;
  const fs::path file = folder / "private.txt";
  writeText(file, "old");
  for (const fs::perms permissions : {fs::perms(0600), fs::perms(0640), fs::perms(0444)}) {
    fs::permissions(file, permissions);
    writeFileAtomically(file, toBytes("new"));
    CHECK(fs::status(file).permissions() == permissions);
  }
}

TEST_CASE("an atomic write does not wait for a program that has locked the folder") {
  TemporaryFolder folder;
  const int locked = ::open(folder.path().c_str(), O_RDONLY | O_DIRECTORY);
  REQUIRE(::flock(locked, LOCK_EX) == 0);
  writeFileAtomically(folder / "a.txt", toBytes("new"));
  ::close(locked);
  CHECK(readText(folder / "a.txt") == "new");
  CHECK(fileCount(folder.path()) == 1);
}

TEST_CASE("a file written in pieces appears when it is committed, not before") {
  TemporaryFolder folder;
  writeText(folder / "a.txt", "old");
  AtomicFile file(folder / "a.txt");
  file.write(toBytes("one, "));
  file.write(toBytes("two"));
  CHECK(readText(folder / "a.txt") == "old");
  file.commit();
  CHECK(readText(folder / "a.txt") == "one, two");
  CHECK(fileCount(folder.path()) == 1);
}

TEST_CASE("a file that is never committed leaves the old file and no other") {
  TemporaryFolder folder;
  writeText(folder / "a.txt", "old");
  AtomicFile(folder / "a.txt").write(toBytes("half of"));
  AtomicFile(folder / "b.txt").write(toBytes("half of"));
  CHECK(readText(folder / "a.txt") == "old");
  CHECK(fileCount(folder.path()) == 1);
}
