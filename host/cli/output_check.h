// Refuses outputs that could not be written, before any work is done for them.
#pragma once
#include <filesystem>
#include <string>

namespace candela::cli {

/// The folder is there and writable (else FileError).
void requireWritableFile(const std::filesystem::path& file);
/// The extension is a known format (else UsageError), and the same.
void requireWritableImage(const std::filesystem::path& file);
/// The same for a JSON report; "-" and "" pass.
void requireWritableReport(const std::string& target);

}  // namespace candela::cli
