// Reads the file of a benchmark report.
#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>

namespace candela::bench {

/// Parses a regular file of at most 64 MiB as JSON. Throws FileError, which names the file.
nlohmann::json readReport(const std::filesystem::path& file);

}  // namespace candela::bench
