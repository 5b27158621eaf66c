// Files that are either there as a whole or not at all.
#pragma once
#include <cstddef>
#include <filesystem>
#include <span>

#include "host/core/file_descriptor.h"

namespace candela {

/// Replaces or creates a file: a temporary one beside it is written, synced and renamed by commit(). Until then, and
/// after any error, the old file stays as it was; the destructor removes the temporary one. A symbolic link keeps
/// pointing to the file that is replaced; devices and pipes are written to as they are. All functions throw FileError
/// that names the file and the cause.
class AtomicFile {
 public:
  explicit AtomicFile(const std::filesystem::path& file);
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  ~AtomicFile();

  void write(std::span<const std::byte> content);
  /// Once, and last.
  void commit();

 private:
  std::filesystem::path name_;  ///< as given, for messages
  bool inPlace_;
  std::filesystem::path target_;     ///< the absolute path behind symbolic links
  std::filesystem::path temporary_;  ///< empty when there is nothing to remove
  FileDescriptor descriptor_;
};

/// The same for content that is in memory.
void writeFileAtomically(const std::filesystem::path& file, std::span<const std::byte> content);

}  // namespace candela
