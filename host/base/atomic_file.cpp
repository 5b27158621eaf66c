// Writes a temporary file beside the target, syncs it and renames it.
#include "host/base/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <string>
#include <system_error>
#include <thread>

#include "host/base/errors.h"

namespace candela {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& file, const std::error_code& cause) {
  throw FileError(fmt::format("cannot write \"{}\": {}", file.string(), cause.message()));
}

[[noreturn]] void failWithErrno(const fs::path& file) { fail(file, std::error_code(errno, std::generic_category())); }

bool writeAll(int descriptor, std::span<const std::byte> content) {
  while (!content.empty()) {
    const ssize_t written = ::write(descriptor, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    content = content.subspan(static_cast<std::size_t>(written));
  }
  return true;
}

/// Returns the absolute path with symbolic links resolved.
fs::path resolveLinks(const fs::path& file) {
  std::error_code error;
  const fs::path absolute = fs::absolute(file, error);
  if (error) fail(file, error);
  fs::path resolved = fs::weakly_canonical(absolute, error);
  if (error) fail(file, error);
  return resolved;
}

/// Returns whether the file is a device, pipe or socket, which a rename would replace by a regular file.
bool isSpecialFile(const fs::path& file) {
  std::error_code ignored;
  const fs::file_type type = fs::status(file, ignored).type();
  return type == fs::file_type::character || type == fs::file_type::block || type == fs::file_type::fifo ||
         type == fs::file_type::socket;
}

/// Returns a name that no other process or thread uses for the same file.
fs::path temporaryName(const fs::path& target) {
  static std::atomic<unsigned> counter = 0;
  fs::path name = target;
  name += fmt::format(".{}.{}.part", ::getpid(), counter++);
  return name;
}

/// Returns the name that a file without a name gets before it replaces the target. It is always the same, so that the
/// file of a killed program is replaced.
fs::path intermediateName(const fs::path& target) {
  fs::path name = target;
  name += ".candela-part";
  return name;
}

/// Returns the path under which the kernel shows an open file of this process.
std::string shownPath(int descriptor) { return fmt::format("/proc/self/fd/{}", descriptor); }

/// Opens a file in the folder that has no name yet, or none if the file system has no such files or if they could not
/// be given a name later.
int openNameless(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, 0666);
  if (descriptor < 0 || ::access(shownPath(descriptor).c_str(), F_OK) == 0) return descriptor;
  ::close(descriptor);
  return -1;
}

/// Opens a device or pipe. A pipe that nobody reads is an error (ENXIO), instead of waiting for a reader.
int openInPlace(const fs::path& file) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
  if (descriptor >= 0) ::fcntl(descriptor, F_SETFL, ::fcntl(descriptor, F_GETFL) & ~O_NONBLOCK);
  return descriptor;
}

/// Syncs the folder, so that the rename survives a power failure. Errors are ignored, since not every file system can
/// sync a folder.
void syncFolder(const fs::path& folder) {
  const FileDescriptor descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (descriptor.isOpen()) ::fsync(descriptor.get());
}

/// Waits at most a second for the lock of a folder, which any program may hold for any time. The lock lasts until the
/// descriptor is closed.
void lockFolder(int folder) {
  constexpr int kMaxTries = 100;
  constexpr std::chrono::milliseconds kPause{10};
  for (int i = 0; i < kMaxTries && ::flock(folder, LOCK_EX | LOCK_NB) != 0; ++i) {
    if (errno != EWOULDBLOCK && errno != EINTR) return;
    std::this_thread::sleep_for(kPause);
  }
}

/// Gives a new file the permissions of the file that it will replace, if there is one. Errors are ignored, since not
/// every file system has permissions.
void copyPermissions(const fs::path& target, int descriptor) {
  constexpr mode_t kPermissions = 0777;
  struct stat status {};
  if (::stat(target.c_str(), &status) == 0) ::fchmod(descriptor, status.st_mode & kPermissions);
}

}  // namespace

AtomicFile::AtomicFile(const fs::path& file)
    : name_(file),
      inPlace_(isSpecialFile(file)),
      target_(inPlace_ ? file : resolveLinks(file)),
      descriptor_(inPlace_ ? openInPlace(target_) : openNameless(target_.parent_path())) {
  if (!inPlace_ && !descriptor_.isOpen()) openNamed();
  if (!descriptor_.isOpen()) failWithErrno(name_);
  if (!inPlace_ && temporary_.empty()) requirePossibleName();
  if (!inPlace_) copyPermissions(target_, descriptor_.get());
}

void AtomicFile::openNamed() {
  const fs::path name = temporaryName(target_);
  descriptor_ = FileDescriptor(::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
  if (descriptor_.isOpen()) temporary_ = name;
}

void AtomicFile::requirePossibleName() const {
  struct stat ignored {};
  if (::lstat(intermediateName(target_).c_str(), &ignored) != 0 && errno == ENAMETOOLONG) failWithErrno(name_);
}

void AtomicFile::giveName(int descriptor) {
  const fs::path name = intermediateName(target_);
  const std::string shown = shownPath(descriptor);
  while (::linkat(AT_FDCWD, shown.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) != 0) {
    if (errno != EEXIST) failWithErrno(name_);
    if (::unlink(name.c_str()) != 0 && errno != ENOENT) failWithErrno(name_);
  }
  temporary_ = name;
}

// Another process that writes the same file would remove the name, and a file that has lost its name cannot get
// another. The folder is therefore locked; where that is not possible, or another program holds the lock, the write may
// fail, but the target is a complete file.
void AtomicFile::replaceTarget(int descriptor) {
  const bool isNameless = temporary_.empty();
  const FileDescriptor folder(::open(target_.parent_path().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder.isOpen()) lockFolder(folder.get());
  if (isNameless) giveName(descriptor);
  while (::rename(temporary_.c_str(), target_.c_str()) != 0) {
    if (!isNameless || errno != ENOENT) failWithErrno(name_);
    giveName(descriptor);
  }
  temporary_.clear();
}

AtomicFile::~AtomicFile() {
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void AtomicFile::write(std::span<const std::byte> content) {
  if (!writeAll(descriptor_.get(), content)) failWithErrno(name_);
}

void AtomicFile::writeAt(std::uint64_t offset, std::span<const std::byte> content) {
  while (!content.empty()) {
    const ssize_t written = ::pwrite(descriptor_.get(), content.data(), content.size(), static_cast<off_t>(offset));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) failWithErrno(name_);
    offset += static_cast<std::uint64_t>(written);
    content = content.subspan(static_cast<std::size_t>(written));
  }
}

void AtomicFile::commit() {
  if (!inPlace_ && ::fsync(descriptor_.get()) != 0) failWithErrno(name_);
  // A file without a name is lost when its last descriptor is closed, and closing reports the last errors.
  const FileDescriptor kept(inPlace_ ? -1 : ::fcntl(descriptor_.get(), F_DUPFD_CLOEXEC, 0));
  if (!inPlace_ && !kept.isOpen()) failWithErrno(name_);
  if (!descriptor_.close()) failWithErrno(name_);
  if (inPlace_) return;
  replaceTarget(kept.get());
  syncFolder(target_.parent_path());
}

void writeFileAtomically(const fs::path& file, std::span<const std::byte> content) {
  AtomicFile output(file);
  output.write(content);
  output.commit();
}

}  // namespace candela
