// Locks of films within a process and between processes.
#include "host/job/film/film_lock.h"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <optional>
#include <utility>

#include "host/base/errors.h"
#include "tests/base/temporary_folder.h"

using namespace candela;
using film::FilmLock;

namespace {

// A process that holds the lock of a film until it is killed.
class OtherProcess {
 public:
  explicit OtherProcess(const std::filesystem::path& film) {
    int ends[2];
    REQUIRE(::pipe(ends) == 0);
    process_ = ::fork();
    if (process_ == 0) holdForever(film, ends[1]);
    char ready = 0;
    REQUIRE(::read(ends[0], &ready, 1) == 1);
    ::close(ends[0]);
    ::close(ends[1]);
  }
  void kill() {
    ::kill(process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
    process_ = 0;
  }
  ~OtherProcess() {
    if (process_ > 0) kill();
  }

 private:
  [[noreturn]] static void holdForever(const std::filesystem::path& film, int ready) {
    const FilmLock lock(film);
    if (::write(ready, "r", 1) != 1) ::_exit(1);
    while (true) ::pause();
  }
  pid_t process_ = 0;
};

}  // namespace

TEST_CASE("a film is locked once at a time, under any of its names, and nothing is left") {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "sub");
  std::filesystem::create_symlink(folder.write("a.exr", "film"), folder / "link.exr");
  std::optional<FilmLock> lock(folder / "a.exr");
  CHECK(lock->isHeld());
  for (const auto& name : {folder / "a.exr", folder / "sub/../a.exr", folder / "link.exr"}) {
    CHECK_THROWS_WITH(FilmLock(name), Catch::Contains("another render is writing this film"));
    CHECK_THROWS_AS(film::requireUnlocked(name), FileError);
  }
  const FilmLock other(folder / "b.exr");
  CHECK(other.isHeld());
  lock.reset();
  CHECK_NOTHROW(film::requireUnlocked(folder / "a.exr"));
  CHECK_FALSE(std::filesystem::exists(folder / "a.exr.candela-lock"));
  CHECK(FilmLock(folder / "link.exr").isHeld());
}

TEST_CASE("parts of a sequence are locked beside each other, and the last lock removes its file") {
  const TemporaryFolder folder;
  const std::filesystem::path pattern = folder / "frame.####.png";
  std::optional<FilmLock> first(std::in_place, pattern, film::LockedPart{0, 10});
  std::optional<FilmLock> second(std::in_place, pattern, film::LockedPart{10, 5});
  CHECK(first->isHeld());
  CHECK(second->isHeld());
  for (const film::LockedPart part : {film::LockedPart{9, 1}, {14, 20}, {0, 100}, {}}) {
    INFO(part.first << " " << part.count);
    CHECK_THROWS_WITH(FilmLock(pattern, part), Catch::Contains("another render is writing"));
  }
  CHECK(FilmLock(pattern, {15, 1}).isHeld());
  first.reset();
  CHECK(folder.fileCount() == 1);
  CHECK(FilmLock(pattern, {0, 10}).isHeld());
  CHECK_THROWS_AS(FilmLock(pattern, {12, 1}), FileError);
  second.reset();
  CHECK(folder.fileCount() == 0);
}

TEST_CASE("a lock that is moved is held by the new object") {
  const TemporaryFolder folder;
  FilmLock lock(folder / "a.exr");
  {
    const FilmLock moved(std::move(lock));
    CHECK_THROWS_AS(FilmLock(folder / "a.exr"), FileError);
  }
  CHECK(FilmLock(folder / "a.exr").isHeld());
}

TEST_CASE("the lock of another process is respected, and ends when that process is killed") {
  const TemporaryFolder folder;
  OtherProcess other(folder / "a.exr");
  CHECK_THROWS_AS(FilmLock(folder / "a.exr"), FileError);
  CHECK_THROWS_AS(film::requireUnlocked(folder / "a.exr"), FileError);
  other.kill();
  CHECK(std::filesystem::exists(folder / "a.exr.candela-lock"));
  CHECK_NOTHROW(film::requireUnlocked(folder / "a.exr"));
  CHECK(FilmLock(folder / "a.exr").isHeld());
  CHECK(folder.fileCount() == 0);
}

TEST_CASE("without a file for the lock there is no lock, and no error") {
  const TemporaryFolder folder;
  const std::string target = folder.write("target", "content");
  std::filesystem::create_symlink(target, folder / "a.exr.candela-lock");
  std::filesystem::create_directory(folder / "b.exr.candela-lock");
  for (const char* name : {"a.exr", "b.exr", "missing/c.exr"}) {
    INFO(name);
    CHECK_FALSE(FilmLock(folder / name).isHeld());
    CHECK_NOTHROW(film::requireUnlocked(folder / name));
  }
  CHECK(readText(target) == "content");
  CHECK(std::filesystem::is_symlink(folder / "a.exr.candela-lock"));
}
