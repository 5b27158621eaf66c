// The formats of image files.
#pragma once
#include <filesystem>
#include <optional>

#include "host/image/codecs.h"

namespace candela::image {

enum class FileFormat { png, jpeg, webp, hdr, pfm, exr };

/// Returns the format that the first bytes of a file name; nothing for any other content.
std::optional<FileFormat> formatByContent(ByteView bytes);

/// Returns the format in which files of this extension are written. Throws UsageError for any other extension.
FileFormat requireFormat(const std::filesystem::path& file);

}  // namespace candela::image
