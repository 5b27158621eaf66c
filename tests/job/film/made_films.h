// Films without a tracer: every sample of every pixel has its own made-up radiance.
#pragma once
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "host/job/film/film_file.h"

namespace candela::film {

inline FilmHeader madeHeader(const render::Extent& size, std::uint32_t samplesPerPixel) {
  FilmHeader header;
  header.sceneHash = "0123456789abcdef";
  header.size = size;
  header.samplesPerPixel = samplesPerPixel;
  header.seed = 7;
  header.settings = {{"integrator", "path"}, {"sampler", "sobol"}};
  header.window = render::windowOf(size);
  header.tracers = {{"a device", "a driver", "a platform", "kernels", "1.0"}};
  return header;
}

// Mostly small values with all their bits, and occasionally a bad one.
inline glm::dvec3 madeRadiance(std::uint32_t x, std::uint32_t y, std::uint32_t sample) {
  std::minstd_rand random(1 + x + 1000 * y + 1000003 * sample);
  random.discard(3);
  const auto number = [&] { return static_cast<double>(random()) / 1073741824.0; };
  const glm::dvec3 radiance(number(), number() * 0.001, number() * 100);
  return random() % 97 == 0 ? -radiance : radiance;
}

/// A part of an image of 64x60 pixels or more, with 9 samples or more.
inline constexpr SampleBox kBox{{3, 5, 37, 50}, {2, 9}};

/// A film of the samples of a box of the image.
inline image::Film madeFilm(const SampleBox& box) {
  image::Film film(box.window.width, box.window.height);
  for (std::uint32_t y = 0; y < box.window.height; ++y) {
    for (std::uint32_t x = 0; x < box.window.width; ++x) {
      for (std::uint32_t i = box.samples.first; i < box.samples.end; ++i) {
        film.addSample(x, y, madeRadiance(box.window.x + x, box.window.y + y, i), i);
      }
    }
  }
  return film;
}

/// Writes the film of a box, and returns its file.
inline std::filesystem::path writeBox(const std::filesystem::path& file, FilmHeader header, const SampleBox& box) {
  header.window = box.window;
  const image::Film film = madeFilm(box);
  setCoverage(header, film, box.samples.first);
  writeFilm(file, header, film);
  return file;
}

inline std::string bytesOf(const std::filesystem::path& file) {
  std::ostringstream bytes;
  bytes << std::ifstream(file, std::ios::binary).rdbuf();
  return bytes.str();
}

inline void writeBytes(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
}

/// The message with which a film file is refused; empty if it is read.
inline std::string refusalOf(const std::filesystem::path& file) {
  try {
    FilmReader reader(file);
    readFilm(reader);
  } catch (const std::exception& error) {
    return error.what();
  }
  return {};
}

}  // namespace candela::film
