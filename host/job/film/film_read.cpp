// Reads film files. Every byte is covered by a checksum, and none reaches OpenEXR before its checksum is right.
#include <OpenEXR/Iex.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <optional>

#include "host/base/divide_up.h"
#include "host/base/errors.h"
#include "host/job/film/coverage_check.h"
#include "host/job/film/exr_threads.h"
#include "host/job/film/film_blocks.h"
#include "host/job/film/film_channels.h"
#include "host/job/film/film_file.h"
#include "host/job/film/film_head.h"
#include "host/job/film/film_mattes.h"
#include "host/job/film/film_memory.h"
#include "host/job/film/film_stream.h"

namespace candela::film {
namespace {

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& reason) {
  throw FileError(fmt::format("{}: {}", file.string(), reason));
}

class FilmInput final : public Imf::IStream {
 public:
  explicit FilmInput(const FilmBytes& bytes) : Imf::IStream("film"), bytes_(bytes) {}

  bool read(char* target, int count) override {
    if (count < 0) throw Iex::InputExc("a negative size");
    bytes_.read(position_, std::span(reinterpret_cast<std::byte*>(target), static_cast<std::size_t>(count)));
    position_ += static_cast<std::uint64_t>(count);
    return position_ < bytes_.size();
  }
  std::uint64_t tellg() override { return position_; }
  void seekg(std::uint64_t position) override { position_ = position; }

 private:
  const FilmBytes& bytes_;
  std::uint64_t position_ = 0;
};

ExrBox exrBoxOf(const render::Window& window) {
  return {static_cast<std::int32_t>(window.x), static_cast<std::int32_t>(window.y),
          static_cast<std::int32_t>(window.x + window.width) - 1,
          static_cast<std::int32_t>(window.y + window.height) - 1};
}

// Throws if the records of layers of a pixel count more samples than the pixel holds.
void checkLayers(const FilmHeader& header, const FilmRows& rows) {
  const std::size_t step = channelsOf(header).layerRows();
  for (std::size_t i = 0; i * step < rows.layerRows.size(); ++i) {
    const image::LayerRow& counts = rows.layerRows[i * step];
    const std::uint32_t samples = rows.pixels[i].sampleCount;
    if (counts.words[0] <= samples && counts.words[1] <= samples) continue;
    throw FileError(fmt::format("pixel ({}, {}) has layers of more samples than it holds",
                                header.window.x + i % header.window.width,
                                header.window.y + rows.first + i / header.window.width));
  }
}

void checkRows(const FilmHeader& header, const FilmRows& rows, CoverageCheck& coverage) {
  const std::size_t width = header.window.width;
  for (std::size_t row = 0; row * width < rows.pixels.size(); ++row) {
    const auto y = header.window.y + rows.first + static_cast<std::uint32_t>(row);
    coverage.checkRow(y, rows.pixels.subspan(row * width, width));
  }
  checkLayers(header, rows);
}

void requireOurs(const Imf::InputFile& input, const ChannelChoice& channels) {
  const bool ours = input.header().compression() == Imf::ZIP_COMPRESSION &&
                    input.header().lineOrder() == Imf::INCREASING_Y &&
                    input.header().channels() == filmChannels(channels) && input.isComplete();
  if (!ours) throw FileError("the channels or the compression are not those of a film file");
}

// Deflate expands a byte to at most 1032.
void requirePlausible(const FilmHeader& header, std::uint64_t fileBytes) {
  constexpr std::uint64_t kMaxExpansion = 1032;
  const std::uint64_t pixels = std::uint64_t{header.window.width} * header.window.height;
  if (pixels * pixelBytes(channelsOf(header)) / kMaxExpansion > fileBytes) {
    throw FileError("the file is truncated");
  }
}

}  // namespace

FilmReader::FilmReader(const std::filesystem::path& file) : file_(file) {
  try {
    blocks_ = std::make_unique<FilmBlocks>(file);
    const FilmBytes& bytes = blocks_->bytes();
    const std::vector<std::byte> start = bytes.bytesAt(0, std::min<std::uint64_t>(bytes.size(), kMaxHeadBytes));
    const FilmHead head = parseHead(start);
    const std::span<const std::byte> table = checkedTable(start, head);
    header_ = headerFromJson(head.description);
    check_ = head.check;
    const render::Window& window = header_.window;
    const bool sameWindows = head.dataWindow == exrBoxOf(window) &&
                             head.displayWindow == exrBoxOf(render::windowOf(header_.size));
    if (!sameWindows) throw FileError("the windows of the picture are not those of the film");
    if (table.size() / 8 != divideUp(window.height, kBlockRows)) throw FileError("blocks are missing");
    requirePlausible(header_, bytes.size());
    blocks_->find(head, header_, table);
  } catch (const FileError& error) {
    fail(file, error.what());
  }
}

FilmReader::~FilmReader() = default;
FilmReader::FilmReader(FilmReader&&) noexcept = default;

void FilmReader::forEachBlock(const std::function<void(const FilmRows&)>& use) try {
  const ChannelChoice channels = channelsOf(header_);
  CoverageCheck coverage(header_);
  std::optional<FilmInput> stream;
  std::optional<Imf::InputFile> input;
  const std::uint32_t threads = exrThreads();
  const std::uint32_t rowsAtATime = std::min(kBlockRows * threads, header_.window.height);
  std::vector<image::FilmPixel> pixels(std::size_t{rowsAtATime} * header_.window.width);
  std::vector<image::LayerRow> layerRows(pixels.size() * channels.layerRows());
  std::vector<std::uint32_t> matteSlots(2 * pixels.size() * channels.slotCount());
  for (std::uint32_t first = 0; first < header_.window.height; first += rowsAtATime) {
    const std::uint32_t rows = std::min(rowsAtATime, header_.window.height - first);
    for (std::uint32_t row = first; row < first + rows; row += kBlockRows) {
      blocks_->check(row / kBlockRows, header_.window);
    }
    if (!input) {
      stream.emplace(blocks_->bytes());
      input.emplace(*stream, static_cast<int>(threads));
      requireOurs(*input, channels);
    }
    const auto top = static_cast<int>(header_.window.y + first);
    const auto left = static_cast<int>(header_.window.x);
    const Imath::Box2i box({left, top},
                           {left + static_cast<int>(header_.window.width) - 1, top + static_cast<int>(rows) - 1});
    const std::size_t count = std::size_t{rows} * header_.window.width;
    Imf::FrameBuffer buffer;
    addWords(buffer, pixels.data(), box, channels.hasAlpha);
    addLayerWords(buffer, layerRows.data(), box, channels);
    addMatteWords(buffer, matteSlots.data(), box, channels);
    input->setFrameBuffer(buffer);
    input->readPixels(box.min.y, box.max.y);
    const FilmRows rowsWithoutIds{first, std::span(pixels).first(count),
                                  std::span(layerRows).first(count * channels.layerRows())};
    checkRows(header_, rowsWithoutIds, coverage);
    const MatteRows mattes = mattesOf(matteSlots, rowsWithoutIds.pixels, header_);
    FilmRows block = rowsWithoutIds;
    block.ids = {mattes[0], mattes[1]};
    use(block);
  }
} catch (const FileError& error) {
  fail(file_, error.what());
} catch (const Iex::BaseExc& error) {
  fail(file_, fmt::format("not a valid EXR file: {}", error.what()));
}

image::Film readFilm(FilmReader& reader) try {
  const render::Window& window = reader.header().window;
  requireMemoryForFilm(window.extent(), reader.header().layers);
  image::Film film(window.width, window.height, reader.header().layers, reader.header().filmScale());
  reader.forEachBlock([&](const FilmRows& rows) {
    std::ranges::copy(rows.pixels, &film.at(0, rows.first));
    if (!rows.layerRows.empty()) std::ranges::copy(rows.layerRows, film.layerRowsAt(0, rows.first).begin());
    for (const image::MatteKind kind : image::kMatteKinds) {
      const auto& ids = rows.ids[static_cast<std::size_t>(kind)];
      if (!ids.empty()) std::ranges::copy(ids, &film.idsAt(kind, 0, rows.first));
    }
  });
  return film;
} catch (const std::bad_alloc&) {
  throw OutOfMemoryError(fmt::format("{}: the film does not fit into memory", reader.file().string()));
}

}  // namespace candela::film
