// Files that appear completely or not at all.
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>

#include "host/base/file_descriptor.h"

namespace candela {

/// Replaces or creates a file. A temporary file beside it is written, synced and renamed by commit(). Until then, and
/// after any error, the old file stays unchanged. Where the file system can, the temporary file has no name before
/// commit(), so that a program that is killed leaves at most one file, which the next write replaces; elsewhere
/// the destructor removes it. A symbolic link still points to the file that is replaced, and the new file has the
/// permissions of the old one. Devices and pipes are written in place. All functions throw FileError, which names the
/// file and the cause.
class AtomicFile {
 public:
  explicit AtomicFile(const std::filesystem::path& file);
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  ~AtomicFile();

  void write(std::span<const std::byte> content);
  /// Writes at an offset in bytes, wherever write() is; not for devices and pipes.
  void writeAt(std::uint64_t offset, std::span<const std::byte> content);
  /// Call it once, as the last function.
  void commit();

 private:
  void openNamed();
  void requirePossibleName() const;
  void giveName(int descriptor);
  void replaceTarget(int descriptor);

  std::filesystem::path name_;  ///< as given, for messages
  bool inPlace_;
  std::filesystem::path target_;     ///< the absolute path, without symbolic links
  std::filesystem::path temporary_;  ///< empty if there is nothing to remove
  FileDescriptor descriptor_;
};

/// Writes content that is in memory as AtomicFile does. Throws FileError.
void writeFileAtomically(const std::filesystem::path& file, std::span<const std::byte> content);

}  // namespace candela
