// Finds the blocks of a film file and compares them with their checksums.
#include "host/job/film/film_blocks.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "host/base/errors.h"
#include "host/job/film/film_channels.h"
#include "host/job/film/film_stream.h"

namespace candela::film {
namespace {

constexpr std::size_t kTableEntryBytes = 8;

[[noreturn]] void failWithCause() { throw FileError(std::error_code(errno, std::generic_category()).message()); }

std::uint64_t littleEndian(std::span<const std::byte> bytes) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) value |= std::to_integer<std::uint64_t>(bytes[i]) << (8 * i);
  return value;
}

}  // namespace

FilmBytes::FilmBytes(const std::filesystem::path& file)
    : descriptor_(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {
  if (!descriptor_.isOpen()) failWithCause();
  struct stat status {};
  if (::fstat(descriptor_.get(), &status) != 0) failWithCause();
  if (!S_ISREG(status.st_mode)) throw FileError("this is not a regular file");
  size_ = static_cast<std::uint64_t>(status.st_size);
}

void FilmBytes::read(std::uint64_t offset, std::span<std::byte> bytes) const {
  while (!bytes.empty()) {
    const ssize_t count = ::pread(descriptor_.get(), bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) failWithCause();
    if (count == 0) throw FileError("the file is truncated");
    offset += static_cast<std::uint64_t>(count);
    bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
}

std::vector<std::byte> FilmBytes::bytesAt(std::uint64_t offset, std::uint64_t count) const {
  std::vector<std::byte> bytes(count);
  read(offset, bytes);
  return bytes;
}

// The digits of the checksum itself are taken as zeros.
std::span<const std::byte> checkedTable(std::span<const std::byte> start, const FilmHead& head) {
  if (head.blockChecks.size() % kCheckDigits != 0) throw FileError("the checksums of the blocks are incomplete");
  const std::size_t tableBytes = head.blockChecks.size() / kCheckDigits * kTableEntryBytes;
  if (start.size() - head.headerBytes < tableBytes) throw FileError("the file is truncated");
  const std::string zeros(kCheckDigits, '0');
  const std::size_t behind = head.checkOffset + kCheckDigits;
  std::uint32_t crc = crc32Of(0, start.first(head.checkOffset));
  crc = crc32Of(crc, std::as_bytes(std::span(zeros)));
  crc = crc32Of(crc, start.subspan(behind, head.headerBytes + tableBytes - behind));
  if (crcText(crc) != head.check) throw FileError("the file is damaged: its header does not match its checksum");
  return start.subspan(head.headerBytes, tableBytes);
}

void FilmBlocks::find(const FilmHead& head, const FilmHeader& header, std::span<const std::byte> table) {
  const render::Window& window = header.window;
  std::uint64_t offset = head.headerBytes + table.size();
  for (std::uint32_t i = 0; i * kTableEntryBytes < table.size(); ++i) {
    if (bytes_.size() < offset + kBlockHeadBytes) throw FileError("the file is truncated");
    const std::vector<std::byte> start = bytes_.bytesAt(offset, kBlockHeadBytes);
    const std::uint64_t size = littleEndian(std::span(start).subspan(4));
    const std::uint64_t rows = std::min(kBlockRows, window.height - i * kBlockRows);
    const bool inPlace = littleEndian(table.subspan(i * kTableEntryBytes, kTableEntryBytes)) == offset &&
                         littleEndian(std::span(start).first(4)) == window.y + i * kBlockRows;
    if (!inPlace || size > rows * window.width * pixelBytes(channelsOf(header))) {
      throw FileError(fmt::format("the file is damaged: block {} is not at its offset", i));
    }
    if (bytes_.size() - offset - kBlockHeadBytes < size) throw FileError("the file is truncated");
    blocks_.push_back({offset, kBlockHeadBytes + size, head.blockChecks.substr(i * kCheckDigits, kCheckDigits)});
    offset += kBlockHeadBytes + size;
  }
  if (offset != bytes_.size()) throw FileError("the file is damaged: data follows its last block");
}

void FilmBlocks::check(std::size_t index, const render::Window& window) const {
  const Block& block = blocks_[index];
  if (crcText(crc32Of(0, bytes_.bytesAt(block.offset, block.bytes))) == block.crc) return;
  const std::uint32_t first = window.y + static_cast<std::uint32_t>(index) * kBlockRows;
  throw FileError(fmt::format("the file is damaged: rows {} to {} do not match their checksum", first,
                              std::min(first + kBlockRows, window.y + window.height) - 1));
}

}  // namespace candela::film
