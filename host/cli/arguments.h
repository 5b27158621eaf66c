// The parsed command line.
#pragma once
#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "host/conformance/picture_test.h"
#include "host/core/log.h"
#include "host/core/tcp_client.h"
#include "host/image/image.h"
#include "host/job/job.h"
#include "host/render/request.h"
#include "host/render/session.h"
#include "host/scene/load.h"
#include "host/verify/light_test.h"
#include "host/view/shown_layer.h"
#include "host/view/view_state.h"

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
  tune = 512,
  doctor = 1024,
  film = 2048,
  merge = 4096,
  conformance = 8192,
  capture = 16384,
  denoise = 32768,
  view = 65536,
  report = 131072
};

struct PixelPosition {
  std::uint32_t x = 0;  ///< from the left
  std::uint32_t y = 0;  ///< from the top
};

/// The cases that `candela conformance` runs, and the files with its expectations.
struct ConformanceArguments {
  bool variants = false;                         ///< the cases are kernels against variants of them
  bool list = false;                             ///< print the names of the cases, and run none
  std::vector<std::string> cases;                ///< patterns of their names; empty: all
  conformance::PictureTest pictures;             ///< how cases that render pictures are tested
  std::optional<std::uint32_t> jobs;             ///< child processes at a time; empty: one per core
  std::optional<std::uint32_t> shuffle;          ///< seed of the order; empty: the order of the list
  double timeout = 60;                           ///< for each case, in seconds
  std::vector<std::filesystem::path> baselines;  ///< empty: every case is expected to pass
  std::vector<std::filesystem::path> skips;
  std::vector<std::filesystem::path> flakes;
  std::string csv;                 ///< like `Arguments::json`
  std::filesystem::path captures;  ///< folder for captures of cases that fail; empty for none
};

/// The folder to which `candela capture` writes, and the device whose results are expected.
struct CaptureArguments {
  std::filesystem::path folder;
  std::string expect;         ///< selector of a device; empty: the reference tracer, or the host for a case
  double shrinkSeconds = 60;  ///< time limit for removing parts of the scene
};

/// A default-constructed object has the default of every option; the option table reads the defaults from it.
struct Arguments {
  Command command = Command::render;
  bool commandNamed = false;       ///< false if `render` was implied
  std::vector<std::string> files;  ///< positional arguments: scenes, images or a kind of scene

  render::RenderRequest request;  ///< resolveRequests() completes it

  scene::LoadOptions loadOptions;

  bool noCache = false;  ///< compiled pipelines are neither read nor written
  bool untuned = false;  ///< `auto` has its built-in meaning
  std::string device;    ///< kReferenceDevice, or a selector for selectDevice()
  std::vector<std::filesystem::path> outputs;
  std::optional<ServerAddress> displayServer;  ///< that shows the image of a render while it is computed
  bool denoise = false;  ///< of a render: its images are denoised, and its films have the sums that this needs
  bool denoisesByOidn = false;
  image::DisplayTransform display;
  std::optional<float>
      exposure = 0.0f;  ///< in stops, which chooseDisplay() sets in `display`; empty: computed from the image

  job::FilmPolicy film;                 ///< of a render
  std::optional<double> hangTimeout;    ///< vulkan::DeviceOptions::hangTimeout
  std::optional<std::uint64_t> memory;  ///< memory budget in bytes; empty: that of the machine
  std::filesystem::path mergedFilm;     ///< film file that `merge` writes
  bool mixedDevices = false;            ///< for `merge`
  bool partial = false;                 ///< for `merge`

  std::optional<double> tolerance;    ///< maximum relMSE that passes
  std::vector<std::string> channels;  ///< that are compared; empty: all but statistics
  std::filesystem::path differenceFile;
  std::filesystem::path flipFile;

  verify::LightTestOptions verification;
  std::string junit;            ///< like `json`
  bool explain = false;         ///< for `verify`: explain the pixel that differs most
  bool allowUndecided = false;  ///< a verdict that is not decided is a success

  std::optional<PixelPosition> pixel;  ///< pixel to explain; empty: the one that differs most
  std::uint32_t sample = 0;

  std::optional<std::uint32_t> generatedSize;  ///< empty: the default of the kind
  std::string generatedFile = "-";             ///< "-": stdout
  std::optional<std::uint32_t> boxDepth;       ///< level of a BVH, 0 for the root; empty: all levels

  std::uint32_t repeats = 3;        ///< runs of each variant of a benchmark
  std::vector<std::string> sweeps;  ///< in the notation of sweepOver()
  double threshold = 0.05;          ///< fraction of its speed that a row may lose
  std::string markdown;             ///< like `json`
  std::string svg;                  ///< like `json`

  view::Mode viewMode = view::Mode::device;  ///< for `view`
  view::ShownLayer viewLayer;                ///< for `view`

  bool dryRun = false;  ///< for `tune`: store nothing

  ConformanceArguments conformance;
  CaptureArguments capture;

  std::filesystem::path report;  ///< HTML file; empty for none
  std::string json;              ///< a file, "-" for stdout, empty for none
  bool printStatistics = false;
  bool strict = false;  ///< bad samples fail a run
  bool quiet = false;
  bool verbose = false;
  bool help = false;
  bool version = false;

  std::set<std::string> given;  ///< long names of the options on the command line

  bool usesReference() const { return device == render::kReferenceDevice; }
  /// Returns whether an image is written to stdout, so that all texts go to stderr.
  bool writesImageToStdout() const {
    return std::ranges::any_of(outputs, image::isStandardOutput) || image::isStandardOutput(differenceFile) ||
           image::isStandardOutput(flipFile);
  }
  /// Returns whether a reporting command prints its report as text.
  bool wantsText() const { return !quiet && json != "-" && markdown != "-" && svg != "-"; }
  Verbosity verbosity() const {
    if (quiet) return Verbosity::quiet;
    return verbose ? Verbosity::verbose : Verbosity::normal;
  }
};

}  // namespace candela::cli
