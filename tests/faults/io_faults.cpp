// Interposes the functions of the C library that write files (LD_PRELOAD), so that chosen calls fail.
//
// CANDELA_IO_FAULT=FUNCTION:N:ERROR fails the N-th call (from 1) of a function, and FUNCTION:N+:ERROR that call and all
// after it; ERROR is the name of an errno value, or SHORT for a write of half of the bytes. Only calls for files whose
// path contains CANDELA_IO_PATH count; `lock` is fcntl() with F_OFD_SETLK. CANDELA_IO_COUNTS names a file to which the
// numbers of calls are appended when the program ends, and CANDELA_IO_LOG one that is created when a fault is injected.
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/types.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <string>

namespace {

constexpr std::array kFunctions{"open", "write", "pwrite", "fsync", "close", "rename", "linkat", "unlink", "lock"};
constexpr int kShort = -1;
constexpr std::array<std::pair<const char*, int>, 10> kErrors{{{"ENOSPC", ENOSPC},
                                                               {"EIO", EIO},
                                                               {"EDQUOT", EDQUOT},
                                                               {"EROFS", EROFS},
                                                               {"EACCES", EACCES},
                                                               {"EINTR", EINTR},
                                                               {"EMFILE", EMFILE},
                                                               {"ENOLCK", ENOLCK},
                                                               {"EOPNOTSUPP", EOPNOTSUPP},
                                                               {"SHORT", kShort}}};

std::array<std::atomic<unsigned long>, kFunctions.size()> calls{};

template <class Pfn>
Pfn next(const char* name) {
  return reinterpret_cast<Pfn>(dlsym(RTLD_NEXT, name));
}

std::string environmentOf(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

bool isWatched(const char* path) {
  const char* const part = std::getenv("CANDELA_IO_PATH");
  return part != nullptr && path != nullptr && std::strstr(path, part) != nullptr;
}

bool isWatched(int descriptor) {
  std::array<char, 4096> path{};
  const std::string link = "/proc/self/fd/" + std::to_string(descriptor);
  const ssize_t length = readlink(link.c_str(), path.data(), path.size() - 1);
  return length > 0 && isWatched(path.data());
}

void createLog() {
  const std::string log = environmentOf("CANDELA_IO_LOG");
  if (std::FILE* file = log.empty() ? nullptr : std::fopen(log.c_str(), "we")) std::fclose(file);
}

int errorNamed(const std::string& name) {
  for (const auto& [known, error] : kErrors) {
    if (name == known) return error;
  }
  std::fprintf(stderr, "CANDELA_IO_FAULT: there is no error %s\n", name.c_str());
  std::abort();
}

/// The error of this call; kShort for a short write.
std::optional<int> faultOf(const char* function) {
  std::size_t index = 0;
  while (std::strcmp(kFunctions[index], function) != 0) ++index;
  const unsigned long number = ++calls[index];
  const std::string fault = environmentOf("CANDELA_IO_FAULT");
  const std::size_t colon = fault.find(':'), second = fault.find(':', colon + 1);
  if (second == std::string::npos || fault.substr(0, colon) != function) return std::nullopt;
  char* end = nullptr;
  const unsigned long first = std::strtoul(fault.c_str() + colon + 1, &end, 10);
  if (*end == '+' ? number < first : number != first) return std::nullopt;
  createLog();
  return errorNamed(fault.substr(second + 1));
}

/// Returns whether the call fails, with errno set.
bool fails(const char* function) {
  const std::optional<int> fault = faultOf(function);
  if (!fault) return false;
  errno = *fault;
  return true;
}

struct Counter {
  ~Counter() {
    const std::string name = environmentOf("CANDELA_IO_COUNTS");
    std::FILE* const file = name.empty() ? nullptr : std::fopen(name.c_str(), "we");
    if (file == nullptr) return;
    for (std::size_t i = 0; i < kFunctions.size(); ++i) {
      std::fprintf(file, "%s %lu\n", kFunctions[i], calls[i].load());
    }
    std::fclose(file);
  }
} counter;

bool createsOrWrites(int flags) { return (flags & O_ACCMODE) != O_RDONLY; }

}  // namespace

extern "C" {

int open(const char* path, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = (flags & (O_CREAT | __O_TMPFILE)) != 0 ? va_arg(arguments, mode_t) : 0;
  va_end(arguments);
  if (createsOrWrites(flags) && isWatched(path) && fails("open")) return -1;
  return next<int (*)(const char*, int, ...)>("open")(path, flags, mode);
}
int open64(const char* path, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = (flags & (O_CREAT | __O_TMPFILE)) != 0 ? va_arg(arguments, mode_t) : 0;
  va_end(arguments);
  return open(path, flags, mode);
}

ssize_t write(int descriptor, const void* data, size_t size) {
  const auto real = next<ssize_t (*)(int, const void*, size_t)>("write");
  if (!isWatched(descriptor)) return real(descriptor, data, size);
  const std::optional<int> fault = faultOf("write");
  if (!fault) return real(descriptor, data, size);
  if (*fault == kShort) return real(descriptor, data, (size + 1) / 2);
  errno = *fault;
  return -1;
}

ssize_t pwrite(int descriptor, const void* data, size_t size, off_t offset) {
  const auto real = next<ssize_t (*)(int, const void*, size_t, off_t)>("pwrite");
  if (!isWatched(descriptor)) return real(descriptor, data, size, offset);
  const std::optional<int> fault = faultOf("pwrite");
  if (!fault) return real(descriptor, data, size, offset);
  if (*fault == kShort) return real(descriptor, data, (size + 1) / 2, offset);
  errno = *fault;
  return -1;
}
ssize_t pwrite64(int descriptor, const void* data, size_t size, off64_t offset) {
  return pwrite(descriptor, data, size, offset);
}

int fsync(int descriptor) {
  if (isWatched(descriptor) && fails("fsync")) return -1;
  return next<int (*)(int)>("fsync")(descriptor);
}

// A descriptor is closed even if closing reports an error, as on Linux.
int close(int descriptor) {
  const bool fault = isWatched(descriptor) && fails("close");
  const int error = errno;
  const int result = next<int (*)(int)>("close")(descriptor);
  if (!fault) return result;
  errno = error;
  return -1;
}

int rename(const char* from, const char* to) {
  if (isWatched(to) && fails("rename")) return -1;
  return next<int (*)(const char*, const char*)>("rename")(from, to);
}

int linkat(int fromFolder, const char* from, int toFolder, const char* to, int flags) {
  if (isWatched(to) && fails("linkat")) return -1;
  return next<int (*)(int, const char*, int, const char*, int)>("linkat")(fromFolder, from, toFolder, to, flags);
}

// All commands have at most one argument, which is passed on as a pointer.
int fcntl(int descriptor, int command, ...) {
  va_list arguments;
  va_start(arguments, command);
  void* const argument = va_arg(arguments, void*);
  va_end(arguments);
  if (command == F_OFD_SETLK && isWatched(descriptor) && fails("lock")) return -1;
  return next<int (*)(int, int, ...)>("fcntl")(descriptor, command, argument);
}
int fcntl64(int descriptor, int command, ...) {
  va_list arguments;
  va_start(arguments, command);
  void* const argument = va_arg(arguments, void*);
  va_end(arguments);
  return fcntl(descriptor, command, argument);
}

int unlink(const char* path) {
  if (isWatched(path) && fails("unlink")) return -1;
  return next<int (*)(const char*)>("unlink")(path);
}
}
