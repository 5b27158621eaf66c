// Prevents two renders from writing the same film, or the same frames of a sequence.
#pragma once
#include <cstdint>
#include <filesystem>

#include "host/base/file_descriptor.h"

namespace candela::film {

/// The part of a file that a lock covers: frames of a pattern, or all of a film.
struct LockedPart {
  std::uint64_t first = 0;
  std::uint64_t count = 0;  ///< 0: everything from `first` on
};

/// The right to write a film file, or frames of a sequence, from construction to destruction. It is an advisory lock
/// (F_OFD_SETLK) on an empty file FILM.candela-lock, which the destructor of the last lock removes. The lock ends with
/// the process in any case: the file that a killed process leaves is not locked, and the next lock uses it. Where the
/// file system has no locks, or the file cannot be created, there is no lock, and isHeld() is false.
class FilmLock {
 public:
  /// `film` need not exist. Symbolic links are resolved. Throws FileError if another lock on a part of `part` is held,
  /// by any process on any machine that shares the file system's locks.
  explicit FilmLock(const std::filesystem::path& film, const LockedPart& part = {});
  FilmLock(FilmLock&& other) noexcept;
  FilmLock& operator=(FilmLock&&) = delete;
  ~FilmLock();

  bool isHeld() const { return descriptor_.isOpen(); }

 private:
  std::filesystem::path file_;  ///< of the lock
  FileDescriptor descriptor_;   ///< open while the lock is held
};

/// Throws FileError if a FilmLock on this film is held. Creates no file.
void requireUnlocked(const std::filesystem::path& film);

}  // namespace candela::film
