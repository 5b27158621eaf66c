// The formats of image files.
#pragma once
#include <filesystem>

#include "host/image/codecs.h"

namespace candela::image {

enum class FileFormat { png, jpeg, hdr, pfm, exr };

/// Returns the format that the first bytes of a file name. Throws FileError for any other content.
FileFormat formatByContent(ByteView bytes);

/// Returns the format that the extension names. Throws UsageError for any other extension.
FileFormat requireFormat(const std::filesystem::path& file);

}  // namespace candela::image
