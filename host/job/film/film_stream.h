// The stream to which OpenEXR writes a film file. Everything before the blocks stays in memory until the checksums are
// known.
#pragma once
#include <OpenEXR/ImfIO.h>

#include <string>
#include <vector>

#include "host/base/atomic_file.h"

namespace candela::film {

/// CRC-32 (that of PNG and zlib), continued from `before`.
std::uint32_t crc32Of(std::uint32_t before, std::span<const std::byte> bytes);
/// 8 hexadecimal digits.
std::string crcText(std::uint32_t crc);

class FilmStream final : public Imf::OStream {
 public:
  explicit FilmStream(AtomicFile& file) : Imf::OStream("film"), file_(file) {}

  void write(const char* source, int count) override;
  std::uint64_t tellp() override { return position_; }
  void seekp(std::uint64_t position) override { position_ = position; }

  /// Declares that the bytes written so far are the head, and that only blocks follow.
  void endHead() { end_ = head_.size(); }
  /// Sets the checksums in the head, which OpenEXR has finished, and writes it. Returns the digits of kCheckAttribute,
  /// which stand for the whole file.
  std::string finish();

 private:
  void addToBlocks(std::span<const std::byte> bytes);

  AtomicFile& file_;
  std::vector<std::byte> head_;
  std::uint64_t position_ = 0;
  std::uint64_t end_ = 0;  ///< of the file; 0: the head is being written
  std::vector<std::uint32_t> blockCrcs_;
  std::vector<std::byte> blockHead_;  ///< of the current block, while it is not complete
  std::uint64_t blockBytesLeft_ = 0;
};

}  // namespace candela::film
