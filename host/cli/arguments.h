// A command line after parsing.
#pragma once
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "host/core/log.h"
#include "host/image/image.h"
#include "host/render/settings.h"
#include "host/verify/light_test.h"

namespace candela::cli {

enum class Command : unsigned {
  render = 1,
  devices = 2,
  check = 4,
  compare = 8,
  generate = 16,
  bench = 32,
  verify = 64,
  boxes = 128,
  explain = 256,
  tune = 512
};

struct PixelPlace {
  std::uint32_t x = 0;  ///< from the left
  std::uint32_t y = 0;  ///< from the top
};

/// Default-constructed, it holds the default of every option; the option table reads them from here.
struct Arguments {
  Command command = Command::render;
  bool commandNamed = false;       ///< `render` may be left out
  std::vector<std::string> files;  ///< what is not an option: scenes, images or a kind of scene

  /// Absent: what the scene file asks for. `settings` has the rest; resolveSettings() joins both.
  std::optional<std::uint32_t> sampleCount;
  std::optional<render::Extent> size;
  std::optional<render::AccelKind> accel;
  std::optional<std::uint32_t> maxDepth;  ///< absent: the integrator's default
  render::RenderSettings settings;

  bool lenient = false;
  std::vector<std::filesystem::path> allowedPaths;

  bool untuned = false;  ///< `auto` means what is built in
  std::string device;    ///< "cpu", or a selector as selectDevice() takes it
  std::vector<std::filesystem::path> outputs;
  image::DisplayTransform display;

  std::optional<double> tolerance;  ///< largest relMSE that passes
  std::filesystem::path differenceFile;
  std::filesystem::path flipFile;

  verify::LightTestOptions verification;
  std::string junit;     ///< as `json`
  bool explain = false;  ///< of `verify`: the pixel that differs most

  std::optional<PixelPlace> pixel;  ///< to be explained; absent: the one that differs most
  std::uint32_t sample = 0;

  std::optional<std::uint32_t> generatedSize;  ///< absent: the kind's default
  std::string generatedFile = "-";             ///< "-": stdout
  std::optional<std::uint32_t> boxDepth;       ///< level of a BVH, the root's being 0; absent: all

  std::uint32_t repeats = 3;        ///< runs of each variant of a benchmark
  std::vector<std::string> sweeps;  ///< as sweepOver() reads them
  double threshold = 0.05;          ///< share of its speed that a row may lose
  std::string markdown;             ///< as `json`
  std::string svg;                  ///< as `json`

  bool dryRun = false;  ///< of `tune`: store nothing

  std::filesystem::path report;  ///< a page; empty for none
  std::string json;              ///< a file, "-" for stdout, empty for none
  bool printStatistics = false;
  bool strict = false;  ///< bad samples fail a run
  bool quiet = false;
  bool verbose = false;
  bool help = false;
  bool version = false;

  std::set<std::string> given;  ///< names (the long ones) of the options that the command line had

  /// Whether a command that only reports prints its report as text.
  bool wantsText() const { return !quiet && json != "-" && markdown != "-" && svg != "-"; }
  Verbosity verbosity() const {
    if (quiet) return Verbosity::quiet;
    return verbose ? Verbosity::verbose : Verbosity::normal;
  }
};

}  // namespace candela::cli
