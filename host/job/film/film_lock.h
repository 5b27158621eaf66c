// Prevents two renders from writing the same film.
#pragma once
#include <filesystem>

#include "host/base/file_descriptor.h"

namespace candela::film {

/// The right to write a film file, from construction to destruction. It is an advisory lock (flock) on an empty file
/// FILM.candela-lock, which the destructor removes. The lock ends with the process in any case: the file that a killed
/// process leaves is not locked, and the next lock uses it. Where the file system has no locks, or the file cannot be
/// created, there is no lock, and isHeld() is false.
class FilmLock {
 public:
  /// `film` need not exist. Symbolic links are resolved. Throws FileError if another lock on this film is held, by any
  /// process on any machine that shares the file system's locks.
  explicit FilmLock(const std::filesystem::path& film);
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
