// Threads that encode and decode blocks of film files, one block each.
#pragma once
#include <cstdint>

namespace candela::film {

/// One per core, at most 16, since each takes the memory of a block. Starts OpenEXR's threads at the first call.
std::uint32_t exrThreads();

}  // namespace candela::film
