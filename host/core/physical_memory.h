// The memory of the machine.
#pragma once
#include <cstdint>

namespace candela {

/// Bytes of physical memory, whether they are free or not.
std::uint64_t physicalMemory();

}  // namespace candela
