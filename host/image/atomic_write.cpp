// Write beside, sync, rename.
#include "host/image/atomic_write.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <string>
#include <system_error>

#include "host/core/errors.h"

namespace candela {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& file, const std::error_code& cause) {
  throw FileError(fmt::format("cannot write \"{}\": {}", file.string(), cause.message()));
}

[[noreturn]] void failWithErrno(const fs::path& file) { fail(file, std::error_code(errno, std::generic_category())); }

class FileDescriptor {
 public:
  explicit FileDescriptor(int value) : value_(value) {}
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;
  ~FileDescriptor() {
    if (value_ >= 0) ::close(value_);
  }
  int get() const { return value_; }
  bool isOpen() const { return value_ >= 0; }
  /// Some file systems report a failed write only here.
  bool close() {
    const int value = value_;
    value_ = -1;
    return ::close(value) == 0;
  }

 private:
  int value_;
};

/// Removes the temporary file unless it got its final name.
class TemporaryFile {
 public:
  explicit TemporaryFile(fs::path path) : path_(std::move(path)) {}
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (!renamed_) ::unlink(path_.c_str());
  }
  const fs::path& path() const { return path_; }
  bool rename(const fs::path& target) {
    renamed_ = ::rename(path_.c_str(), target.c_str()) == 0;
    return renamed_;
  }

 private:
  fs::path path_;
  bool renamed_ = false;
};

bool writeAll(int descriptor, std::span<const std::byte> content) {
  while (!content.empty()) {
    const ssize_t written = ::write(descriptor, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    content = content.subspan(static_cast<std::size_t>(written));
  }
  return true;
}

/// The absolute path behind symbolic links.
fs::path resolveLinks(const fs::path& file) {
  std::error_code error;
  const fs::path absolute = fs::absolute(file, error);
  if (error) fail(file, error);
  fs::path resolved = fs::weakly_canonical(absolute, error);
  if (error) fail(file, error);
  return resolved;
}

/// Devices, pipes, sockets: a rename would replace them by an ordinary file.
bool isSpecialFile(const fs::path& file) {
  std::error_code ignored;
  const fs::file_type type = fs::status(file, ignored).type();
  return type == fs::file_type::character || type == fs::file_type::block || type == fs::file_type::fifo ||
         type == fs::file_type::socket;
}

void writeInPlace(const fs::path& file, std::span<const std::byte> content) {
  FileDescriptor descriptor(::open(file.c_str(), O_WRONLY | O_CLOEXEC));
  if (!descriptor.isOpen() || !writeAll(descriptor.get(), content) || !descriptor.close()) failWithErrno(file);
}

/// Two processes, or two threads, that write the same file do not meet in the temporary one.
fs::path temporaryName(const fs::path& target) {
  static std::atomic<unsigned> counter = 0;
  fs::path name = target;
  name += fmt::format(".{}.{}.part", ::getpid(), counter++);
  return name;
}

/// Makes the rename itself survive a power failure. Not every file system can sync a folder, so errors do not count.
void syncFolder(const fs::path& folder) {
  const FileDescriptor descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (descriptor.isOpen()) ::fsync(descriptor.get());
}

}  // namespace

void writeFileAtomically(const fs::path& file, std::span<const std::byte> content) {
  if (isSpecialFile(file)) return writeInPlace(file, content);
  const fs::path target = resolveLinks(file);
  const fs::path temporaryPath = temporaryName(target);
  FileDescriptor descriptor(::open(temporaryPath.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
  if (!descriptor.isOpen()) failWithErrno(file);

  TemporaryFile temporary(temporaryPath);
  if (!writeAll(descriptor.get(), content) || ::fsync(descriptor.get()) != 0 || !descriptor.close()) {
    failWithErrno(file);
  }
  if (!temporary.rename(target)) failWithErrno(file);
  syncFolder(target.parent_path());
}

}  // namespace candela
