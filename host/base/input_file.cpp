// Opens without blocking, and looks at the kind of file before it reads.
#include "host/base/input_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "host/base/errors.h"
#include "host/base/file_descriptor.h"

namespace candela {
namespace {

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& reason) {
  throw FileError(fmt::format("{}: {}", file.string(), reason));
}

struct stat statusOf(const std::filesystem::path& file, int descriptor) {
  struct stat status {};
  if (::fstat(descriptor, &status) != 0) fail(file, fmt::format("cannot read: {}", std::strerror(errno)));
  return status;
}

void requireKind(const std::filesystem::path& file, const struct stat& status, InputKind kind) {
  if (S_ISREG(status.st_mode)) return;
  if (kind == InputKind::regularFileOrPipe && S_ISFIFO(status.st_mode)) return;
  fail(file, S_ISDIR(status.st_mode) ? "is a folder" : "is not a regular file");
}

void waitForData(const std::filesystem::path& file, int descriptor) {
  constexpr int kMaxSilenceMilliseconds = 10'000;
  pollfd poll{descriptor, POLLIN, 0};
  const int ready = ::poll(&poll, 1, kMaxSilenceMilliseconds);
  if (ready == 0) fail(file, "the other end of the pipe writes nothing");
}

}  // namespace

std::string readInputFile(const std::filesystem::path& file, std::size_t maxBytes, InputKind kind) {
  const FileDescriptor descriptor(::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  if (!descriptor.isOpen()) fail(file, fmt::format("cannot open: {}", std::strerror(errno)));
  const struct stat status = statusOf(file, descriptor.get());
  requireKind(file, status, kind);
  const std::string tooLarge = fmt::format("larger than {} MiB", maxBytes >> 20);
  if (static_cast<std::uint64_t>(status.st_size) > maxBytes) fail(file, tooLarge);
  std::string text;
  if (S_ISREG(status.st_mode)) text.reserve(static_cast<std::size_t>(status.st_size));
  // Before its writer has opened it, read() takes a pipe for one that has ended.
  if (S_ISFIFO(status.st_mode)) waitForData(file, descriptor.get());
  std::string block(std::size_t{1} << 20, '\0');
  for (;;) {
    const ssize_t count = ::read(descriptor.get(), block.data(), block.size());
    if (count == 0) return text;
    if (count < 0 && errno == EAGAIN) {
      waitForData(file, descriptor.get());
    } else if (count < 0 && errno != EINTR) {
      fail(file, fmt::format("cannot read: {}", std::strerror(errno)));
    } else if (count > 0) {
      text.append(block, 0, static_cast<std::size_t>(count));
      if (text.size() > maxBytes) fail(file, tooLarge);
    }
  }
}

}  // namespace candela
