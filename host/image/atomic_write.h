// Files that are either there as a whole or not at all.
#pragma once
#include <cstddef>
#include <filesystem>
#include <span>

namespace candela {

/// Replaces or creates a file: writes a temporary one beside it, syncs, renames. On any error the old file stays as it
/// was and the temporary one is removed. A symbolic link keeps pointing to the file that is replaced; devices and
/// pipes are written to as they are. Throws FileError that names the file and the cause.
void writeFileAtomically(const std::filesystem::path& file, std::span<const std::byte> content);

}  // namespace candela
