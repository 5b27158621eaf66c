// Recognises the formats of image files by their extensions and their first bytes.
#include "host/image/image_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "host/base/errors.h"
#include "host/base/file_extension.h"
#include "host/image/image.h"

namespace candela::image {
namespace {

namespace fs = std::filesystem;

std::optional<FileFormat> formatByExtension(const fs::path& file) {
  const std::string extension = extensionOf(file);
  if (extension == ".png") return FileFormat::png;
  if (extension == ".jpg" || extension == ".jpeg") return FileFormat::jpeg;
  if (extension == ".hdr") return FileFormat::hdr;
  if (extension == ".pfm") return FileFormat::pfm;
  if (extension == ".exr") return FileFormat::exr;
  return std::nullopt;
}

}  // namespace

std::optional<FileFormat> formatByContent(ByteView bytes) {
  const std::string_view start(reinterpret_cast<const char*>(bytes.data()), std::min<std::size_t>(bytes.size(), 12));
  if (start.starts_with("\x89PNG")) return FileFormat::png;
  if (start.starts_with("\xff\xd8")) return FileFormat::jpeg;
  if (start.starts_with("RIFF") && start.ends_with("WEBP")) return FileFormat::webp;
  if (start.starts_with("#?")) return FileFormat::hdr;
  if (start.starts_with("PF") || start.starts_with("Pf")) return FileFormat::pfm;
  if (start.starts_with("\x76\x2f\x31\x01")) return FileFormat::exr;
  return std::nullopt;
}

FileFormat requireFormat(const fs::path& file) {
  const std::optional<FileFormat> format = file == "-" ? FileFormat::png : formatByExtension(file);
  if (format) return *format;
  throw UsageError(fmt::format("\"{}\": the name of an image file must end in .png, .jpg, .jpeg, .hdr, .pfm or .exr",
                               file.string()));
}

bool isStandardOutput(const fs::path& file) {
  return file == "-" || (!file.has_parent_path() && file.stem() == "-" && formatByExtension(file));
}

bool hasImageExtension(const fs::path& file) {
  return formatByExtension(file).has_value() || extensionOf(file) == ".webp";
}

void checkImageFormat(const fs::path& file) { requireFormat(file); }

bool isEightBit(const fs::path& file) {
  const FileFormat format = requireFormat(file);
  return format == FileFormat::png || format == FileFormat::jpeg;
}

bool isExr(const fs::path& file) { return requireFormat(file) == FileFormat::exr; }

}  // namespace candela::image
