// Locks a file beside the film, because the film itself is replaced by every write.
#include "host/job/film/film_lock.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <cerrno>
#include <chrono>
#include <thread>
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

/// Tries to lock a part of an open file: `type` is F_WRLCK or F_RDLCK. The lock belongs to the open file description.
Attempt tryLock(int descriptor, short type, const LockedPart& part) {
  struct flock lock {};
  lock.l_type = type;
  lock.l_whence = SEEK_SET;
  lock.l_start = static_cast<off_t>(part.first);
  lock.l_len = static_cast<off_t>(part.count);
  int result = 0;
  do {
    result = ::fcntl(descriptor, F_OFD_SETLK, &lock);
  } while (result != 0 && errno == EINTR);
  if (result == 0) return Attempt::locked;
  return errno == EAGAIN || errno == EACCES ? Attempt::refused : Attempt::impossible;
}

/// Returns whether the file still has its name: an earlier owner of the lock may have removed it since it was opened.
bool hasName(int descriptor, const fs::path& file) {
  struct stat opened {
  }, named{};
  return ::fstat(descriptor, &opened) == 0 && ::lstat(file.c_str(), &named) == 0 && opened.st_ino == named.st_ino &&
         opened.st_dev == named.st_dev;
}

[[noreturn]] void refuse(const fs::path& film, const LockedPart& part) {
  const char* const object = part.count == 0 ? "this film" : "some of these frames";
  throw FileError(
      fmt::format("{}: another render is writing {}; wait for its end, or choose another file", film.string(), object));
}

}  // namespace

// A lock on another part covers the whole file for a moment when it ends, so that a refusal is believed only if it is
// repeated.
FilmLock::FilmLock(const fs::path& film, const LockedPart& part) : file_(lockFile(film)), descriptor_(-1) {
  constexpr int kRefusals = 3;
  constexpr std::chrono::milliseconds kPause{5};
  for (int refusals = 0;;) {
    FileDescriptor opened(::open(file_.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0666));
    if (!opened.isOpen()) return;
    const Attempt attempt = tryLock(opened.get(), F_WRLCK, part);
    if (attempt == Attempt::impossible) {
      ::unlink(file_.c_str());
      return;
    }
    if (attempt == Attempt::refused) {
      if (++refusals == kRefusals) refuse(film, part);
      std::this_thread::sleep_for(kPause);
      continue;
    }
    if (!hasName(opened.get(), file_)) continue;
    descriptor_ = std::move(opened);
    return;
  }
}

FilmLock::FilmLock(FilmLock&& other) noexcept : file_(std::move(other.file_)), descriptor_(-1) {
  descriptor_ = std::move(other.descriptor_);
}

// Nobody else holds a part of the file if all of it can be locked: then its name is removed first, so that no one locks
// a file that is about to lose its name. The lock is released explicitly, since a forked process may have inherited the
// descriptor.
FilmLock::~FilmLock() {
  if (!isHeld()) return;
  if (tryLock(descriptor_.get(), F_WRLCK, {}) == Attempt::locked) ::unlink(file_.c_str());
  tryLock(descriptor_.get(), F_UNLCK, {});
}

void requireUnlocked(const fs::path& film) {
  const FileDescriptor opened(::open(lockFile(film).c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  if (opened.isOpen() && tryLock(opened.get(), F_RDLCK, {}) == Attempt::refused) refuse(film, {});
}

}  // namespace candela::film
