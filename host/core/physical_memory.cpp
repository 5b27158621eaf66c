// Asks the operating system for the memory of the machine.
#include "host/core/physical_memory.h"

#include <unistd.h>

namespace candela {

std::uint64_t physicalMemory() {
  return static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

}  // namespace candela
