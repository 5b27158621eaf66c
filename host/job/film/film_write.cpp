// Writes film files.
#include <OpenEXR/Iex.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <fmt/format.h>

#include <algorithm>

#include "host/base/divide_up.h"
#include "host/base/errors.h"
#include "host/job/film/exr_threads.h"
#include "host/job/film/film_channels.h"
#include "host/job/film/film_file.h"
#include "host/job/film/film_mattes.h"
#include "host/job/film/film_stream.h"

namespace candela::film {
namespace {

Imath::Box2i boxOf(const render::Window& window) {
  const Imath::V2i low(static_cast<int>(window.x), static_cast<int>(window.y));
  return {low, low + Imath::V2i(static_cast<int>(window.width) - 1, static_cast<int>(window.height) - 1)};
}

// The attributes beside kFilmAttribute are copies for programs that compare pictures.
Imf::Header exrHeader(const FilmHeader& header) {
  const std::uint32_t blocks = divideUp(header.window.height, kBlockRows);
  Imf::Header exr(boxOf(render::windowOf(header.size)), boxOf(header.window));
  exr.compression() = Imf::ZIP_COMPRESSION;
  exr.channels() = filmChannels(channelsOf(header));
  Imf::addChromaticities(exr, Imf::Chromaticities());  // the default is Rec. 709
  exr.insert("candela.sceneHash", Imf::StringAttribute(header.sceneHash));
  exr.insert("candela.samplesPerPixel", Imf::StringAttribute(fmt::to_string(header.samplesPerPixel)));
  exr.insert("candela.seed", Imf::StringAttribute(fmt::to_string(header.seed)));
  exr.insert(kFilmAttribute, Imf::StringAttribute(toJson(header)));
  exr.insert(kBlocksAttribute, Imf::StringAttribute(std::string(kCheckDigits * blocks, '0')));
  exr.insert(kCheckAttribute, Imf::StringAttribute(std::string(kCheckDigits, '0')));
  return exr;
}

void fillPicture(const image::Film& film, std::uint32_t firstRow, std::uint32_t rows,
                 std::vector<PicturePixel>& picture) {
  picture.clear();
  for (std::uint32_t y = firstRow; y < firstRow + rows; ++y) {
    for (std::uint32_t x = 0; x < film.width(); ++x) {
      const glm::vec3 mean(film.mean(x, y));
      picture.push_back({mean.x, mean.y, mean.z, static_cast<float>(film.luminanceVariance(x, y)),
                         static_cast<float>(film.alpha(x, y))});
    }
  }
}

void addPicture(Imf::FrameBuffer& buffer, const std::vector<PicturePixel>& picture, const Imath::Box2i& rows,
                bool hasAlpha) {
  const auto width = static_cast<std::size_t>(rows.max.x - rows.min.x + 1);
  for (const PictureChannel& channel : pictureChannels(hasAlpha)) {
    const std::byte* const first = reinterpret_cast<const std::byte*>(picture.data()) + channel.offset;
    buffer.insert(channel.name,
                  Imf::Slice::Make(Imf::FLOAT, first, rows, sizeof(PicturePixel), width * sizeof(PicturePixel)));
  }
}

// Several blocks at a time, so that threads have one each.
void writeBlocks(Imf::OutputFile& output, const FilmHeader& header, const image::Film& film,
                 std::uint32_t rowsAtATime) {
  const ChannelChoice channels = channelsOf(header);
  std::vector<PicturePixel> picture;
  for (std::uint32_t first = 0; first < header.window.height; first += rowsAtATime) {
    const std::uint32_t rows = std::min(rowsAtATime, header.window.height - first);
    const Imath::Box2i box = boxOf({header.window.x, header.window.y + first, header.window.width, rows});
    fillPicture(film, first, rows, picture);
    Imf::FrameBuffer buffer;
    addPicture(buffer, picture, box, channels.hasAlpha);
    addWords(buffer, &film.at(0, first), box, channels.hasAlpha);
    addLayerWords(buffer, film.layerRowsAt(0, first).data(), box, channels);
    const std::vector<std::uint32_t> mattes = matteWords(film, std::size_t{first} * film.width(),
                                                         std::size_t{rows} * film.width(), channels);
    addMatteWords(buffer, mattes.data(), box, channels);
    output.setFrameBuffer(buffer);
    output.writePixels(static_cast<int>(rows));
  }
}

}  // namespace

std::string writeFilm(const std::filesystem::path& file, const FilmHeader& given, const image::Film& film) try {
  FilmHeader header = given;
  header.matteSlots = slotsOf(film);
  const std::uint32_t threads = exrThreads();
  AtomicFile target(file);
  FilmStream stream(target);
  {
    Imf::OutputFile output(stream, exrHeader(header),
                           static_cast<int>(threads));  // its destructor writes the table of offsets
    stream.endHead();
    writeBlocks(output, header, film, kBlockRows * threads);
  }
  std::string check = stream.finish();
  target.commit();
  return check;
} catch (const Iex::BaseExc& error) {
  throw FileError(fmt::format("cannot write \"{}\": {}", file.string(), error.what()));
}

}  // namespace candela::film
