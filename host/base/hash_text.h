// The notation of hashes in reports.
#pragma once
#include <fmt/format.h>

#include <cstdint>
#include <string>

namespace candela {

/// Returns 16 hexadecimal digits.
inline std::string hashText(std::uint64_t hash) { return fmt::format("{:016x}", hash); }

}  // namespace candela
