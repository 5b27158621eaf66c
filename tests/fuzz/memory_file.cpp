// A nameless file in memory, which has a path while it is open.
#include <sys/mman.h>
#include <unistd.h>

#include <cstdlib>

#include "tests/fuzz/fuzz.h"

namespace candela::fuzz {

std::filesystem::path fileOf(Input input) {
  static const int descriptor = memfd_create("candela-fuzz", MFD_CLOEXEC);
  const bool written = descriptor >= 0 && ftruncate(descriptor, 0) == 0 &&
                       pwrite(descriptor, input.data(), input.size(), 0) == static_cast<ssize_t>(input.size());
  if (!written) std::abort();
  return "/proc/self/fd/" + std::to_string(descriptor);
}

}  // namespace candela::fuzz
