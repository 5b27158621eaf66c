// Reads a regular file of limited size.
#include "host/job/cache/read_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "host/base/file_descriptor.h"

namespace candela::cache {

std::optional<std::string> readRegularFile(const std::filesystem::path& file, std::size_t maxBytes,
                                           std::string& problem) {
  const FileDescriptor descriptor(::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  if (!descriptor.isOpen()) {
    if (errno != ENOENT && errno != ENOTDIR) problem = std::generic_category().message(errno);
    return std::nullopt;
  }
  struct stat status {};
  if (::fstat(descriptor.get(), &status) != 0 || !S_ISREG(status.st_mode)) {
    problem = "not a regular file";
    return std::nullopt;
  }
  if (static_cast<std::uint64_t>(status.st_size) > maxBytes) {
    problem = "too large";
    return std::nullopt;
  }
  std::string text(static_cast<std::size_t>(status.st_size), '\0');
  std::size_t size = 0;
  while (size < text.size()) {
    const ssize_t count = ::read(descriptor.get(), text.data() + size, text.size() - size);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) problem = std::generic_category().message(errno);
    if (count <= 0) break;
    size += static_cast<std::size_t>(count);
  }
  text.resize(size);
  return problem.empty() ? std::optional(std::move(text)) : std::nullopt;
}

}  // namespace candela::cache
