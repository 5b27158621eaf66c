// Splits the output of OpenEXR into the head and the blocks, and computes the checksums.
#include "host/job/film/film_stream.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <cstring>

#include "host/base/errors.h"
#include "host/job/film/film_channels.h"

namespace candela::film {
namespace {

std::uint32_t littleEndianWord(const std::byte* bytes) {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < 4; ++i) word |= std::to_integer<std::uint32_t>(bytes[i]) << (8 * i);
  return word;
}

// Returns the position of the value of a string attribute in the head: after its name, type and size.
std::size_t valueOffset(std::span<const std::byte> head, std::string_view name) {
  const std::string before = std::string(name) + '\0' + "string" + '\0';
  const std::string_view text(reinterpret_cast<const char*>(head.data()), head.size());
  const std::size_t found = text.find(before);
  if (found == std::string_view::npos) throw InternalError("a film file without checksums");
  return found + before.size() + 4;
}

void replaceAt(std::span<std::byte> head, std::size_t offset, const std::string& text) {
  std::memcpy(head.subspan(offset, text.size()).data(), text.data(), text.size());
}

}  // namespace

std::uint32_t crc32Of(std::uint32_t before, std::span<const std::byte> bytes) {
  return static_cast<std::uint32_t>(crc32_z(before, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

std::string crcText(std::uint32_t crc) { return fmt::format("{:08x}", crc); }

void FilmStream::write(const char* source, int count) {
  const std::span bytes(reinterpret_cast<const std::byte*>(source), static_cast<std::size_t>(count));
  if (end_ == 0 || position_ < head_.size()) {
    head_.resize(std::max<std::size_t>(head_.size(), position_ + bytes.size()));
    std::memcpy(head_.data() + position_, bytes.data(), bytes.size());
  } else {
    if (position_ != end_) throw InternalError("the blocks of a film file are not written one after the other");
    file_.writeAt(position_, bytes);
    addToBlocks(bytes);
    end_ += bytes.size();
  }
  position_ += bytes.size();
}

void FilmStream::addToBlocks(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    if (blockBytesLeft_ == 0) {
      const std::size_t taken = std::min(kBlockHeadBytes - blockHead_.size(), bytes.size());
      blockHead_.insert(blockHead_.end(), bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(taken));
      bytes = bytes.subspan(taken);
      if (blockHead_.size() < kBlockHeadBytes) return;
      blockCrcs_.push_back(crc32Of(0, blockHead_));
      blockBytesLeft_ = littleEndianWord(blockHead_.data() + 4);
      blockHead_.clear();
      continue;
    }
    const std::size_t taken = std::min<std::uint64_t>(blockBytesLeft_, bytes.size());
    blockCrcs_.back() = crc32Of(blockCrcs_.back(), bytes.first(taken));
    blockBytesLeft_ -= taken;
    bytes = bytes.subspan(taken);
  }
}

std::string FilmStream::finish() {
  std::string blocks;
  for (const std::uint32_t crc : blockCrcs_) blocks += crcText(crc);
  replaceAt(head_, valueOffset(head_, kBlocksAttribute), blocks);
  const std::string check = crcText(crc32Of(0, head_));
  replaceAt(head_, valueOffset(head_, kCheckAttribute), check);
  file_.writeAt(0, head_);
  return check;
}

}  // namespace candela::film
