// Locks a file beside the film, because the film itself is replaced by every write.
#include "host/job/film/film_lock.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <cerrno>
#include <utility>

#include "host/base/errors.h"

namespace candela::film {
namespace {

namespace fs = std::filesystem;

enum class Attempt { locked, refused, impossible };

fs::path lockFile(const fs::path& film) {
  std::error_code ignored;
  fs::path file = fs::weakly_canonical(fs::absolute(film, ignored), ignored);
  if (file.empty()) file = film;
  file += ".candela-lock";
  return file;
}

/// Tries to lock an open file: `operation` is LOCK_EX or LOCK_SH.
Attempt tryLock(int descriptor, int operation) {
  int result = 0;
  do {
    result = ::flock(descriptor, operation | LOCK_NB);
  } while (result != 0 && errno == EINTR);
  if (result == 0) return Attempt::locked;
  return errno == EWOULDBLOCK ? Attempt::refused : Attempt::impossible;
}

/// Returns whether the file still has its name: an earlier owner of the lock may have removed it since it was opened.
bool hasName(int descriptor, const fs::path& file) {
  struct stat opened {
  }, named{};
  return ::fstat(descriptor, &opened) == 0 && ::lstat(file.c_str(), &named) == 0 && opened.st_ino == named.st_ino &&
         opened.st_dev == named.st_dev;
}

[[noreturn]] void refuse(const fs::path& film) {
  throw FileError(
      fmt::format("{}: another render is writing this film; wait for its end, or choose another file", film.string()));
}

}  // namespace

FilmLock::FilmLock(const fs::path& film) : file_(lockFile(film)), descriptor_(-1) {
  while (true) {
    FileDescriptor opened(::open(file_.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0666));
    if (!opened.isOpen()) return;
    const Attempt attempt = tryLock(opened.get(), LOCK_EX);
    if (attempt == Attempt::refused) refuse(film);
    if (attempt == Attempt::impossible) {
      ::unlink(file_.c_str());
      return;
    }
    if (!hasName(opened.get(), file_)) continue;
    descriptor_ = std::move(opened);
    return;
  }
}

FilmLock::FilmLock(FilmLock&& other) noexcept : file_(std::move(other.file_)), descriptor_(-1) {
  descriptor_ = std::move(other.descriptor_);
}

// The name is removed first, so that no one locks a file that is about to lose its name. The lock is released
// explicitly, since a forked process may have inherited the descriptor.
FilmLock::~FilmLock() {
  if (!isHeld()) return;
  ::unlink(file_.c_str());
  ::flock(descriptor_.get(), LOCK_UN);
}

void requireUnlocked(const fs::path& film) {
  const FileDescriptor opened(::open(lockFile(film).c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  if (opened.isOpen() && tryLock(opened.get(), LOCK_SH) == Attempt::refused) refuse(film);
}

}  // namespace candela::film
