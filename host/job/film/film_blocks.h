// The bytes of a film file and its blocks, with their checksums. Internal to the film layer.
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "host/base/file_descriptor.h"
#include "host/job/film/film_head.h"
#include "host/job/film/film_header.h"
#include "host/trace/render/extent.h"

namespace candela::film {

/// A regular file, read at any offset. Throws FileError without the name of the file.
class FilmBytes {
 public:
  explicit FilmBytes(const std::filesystem::path& file);

  std::uint64_t size() const { return size_; }
  void read(std::uint64_t offset, std::span<std::byte> bytes) const;
  std::vector<std::byte> bytesAt(std::uint64_t offset, std::uint64_t count) const;

 private:
  FileDescriptor descriptor_;
  std::uint64_t size_ = 0;
};

/// The table of blocks that follows the header in `start`. Throws FileError, without the name of the file, unless
/// header and table match their checksum.
std::span<const std::byte> checkedTable(std::span<const std::byte> start, const FilmHead& head);

/// The members throw FileError without the name of the file.
class FilmBlocks {
 public:
  explicit FilmBlocks(const std::filesystem::path& file) : bytes_(file) {}

  const FilmBytes& bytes() const { return bytes_; }
  std::size_t count() const { return blocks_.size(); }

  /// Finds the blocks of the film's window and requires that they are adjacent up to the end of the file,
  /// as the table says.
  void find(const FilmHead& head, const FilmHeader& header, std::span<const std::byte> table);
  /// Requires that a block matches its checksum.
  void check(std::size_t index, const render::Window& window) const;

 private:
  struct Block {
    std::uint64_t offset;
    std::uint64_t bytes;  ///< with its row and size
    std::string crc;
  };

  FilmBytes bytes_;
  std::vector<Block> blocks_;
};

}  // namespace candela::film
