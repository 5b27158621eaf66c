// Reads files whose content must not be trusted.
#pragma once
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace candela::cache {

/// Returns the content of a regular file of at most `maxBytes` bytes. Otherwise returns nothing and sets `problem`,
/// which stays empty if the file does not exist. Devices and pipes are refused, since reading them could block forever.
std::optional<std::string> readRegularFile(const std::filesystem::path& file, std::size_t maxBytes,
                                           std::string& problem);

}  // namespace candela::cache
