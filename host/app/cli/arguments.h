// Parts of the arguments that several commands share. The struct of a command (host/app/cli/command_arguments.h)
// derives from the parts that it has, and a function takes the parts that it reads.
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "host/base/log.h"
#include "host/formats/loading/load.h"
#include "host/image/image.h"
#include "host/job/sequence.h"
#include "host/judge/verify/light_test.h"
#include "host/trace/render/request.h"
#include "host/trace/render/session.h"

namespace candela::cli {

// A default-constructed object has the default of every option; the option table reads the defaults from it.

/// The arguments of every command.
struct GeneralArguments {
  bool commandNamed = false;       ///< false if `render` was implied
  std::vector<std::string> files;  ///< positional arguments: scenes, images or a kind of scene
  bool quiet = false;
  bool verbose = false;
  bool help = false;
  bool version = false;
  std::set<std::string> given;  ///< long names of the options on the command line

  Verbosity verbosity() const {
    if (quiet) return Verbosity::quiet;
    return verbose ? Verbosity::verbose : Verbosity::normal;
  }
};

struct MemoryArguments {
  std::optional<std::uint64_t> memory;  ///< memory budget in bytes; empty: that of the machine
};

/// How scene files are read.
struct SceneArguments : GeneralArguments, MemoryArguments {
  scene::LoadOptions loadOptions;
};

struct RequestArguments {
  render::RenderRequest request;  ///< the scene completes it
};

struct DeviceArguments {
  std::string device;  ///< kReferenceDevice, or a selector for selectDevice()

  bool usesReference() const { return device == render::kReferenceDevice; }
};

/// How a device is opened.
struct OpenDeviceArguments : DeviceArguments {
  bool noCache = false;               ///< compiled pipelines are neither read nor written
  std::optional<double> hangTimeout;  ///< vulkan::DeviceOptions::hangTimeout
};

/// A scene and how it is traced.
struct TracingArguments : SceneArguments, RequestArguments, OpenDeviceArguments {
  bool untuned = false;  ///< `auto` has its built-in meaning
};

/// The frames of a sequence. Without any, a command renders one image.
struct SequenceArguments {
  std::optional<job::FrameRange> frames;   ///< empty: those of a turn, or no sequence
  double framesPerSecond = 24;             ///< of the animation
  std::optional<std::uint32_t> turntable;  ///< number of frames in which the camera turns once about its target
  bool seedIsFrame = false;                ///< the number of a frame is its seed

  bool isSequence() const { return frames || turntable; }
};

/// How images are shown, in files of 8 bits and elsewhere.
struct PictureArguments {
  std::optional<image::ToneMap> toneMap;  ///< empty: sRGB, and false colours for depths and costs
  std::optional<float> exposure = 0.0f;   ///< in stops; empty: computed from the image
};

struct ImageFileArguments : PictureArguments {
  std::vector<std::filesystem::path> outputs;
};

struct DenoisingArguments {
  bool denoise = false;  ///< of a render: its images are denoised, and its films have the sums that this needs
  bool denoisesByOidn = false;
};

/// A verdict on two images or tracers.
struct VerdictArguments {
  verify::LightTestOptions verification;
  bool allowUndecided = false;   ///< a verdict that is not decided is a success
  std::filesystem::path report;  ///< HTML file; empty for none
};

struct StrictArguments {
  bool strict = false;  ///< bad samples fail a run
};

struct PixelPosition {
  std::uint32_t x = 0;  ///< from the left
  std::uint32_t y = 0;  ///< from the top
};

/// One sample of a render.
struct SampleArguments {
  std::optional<PixelPosition> pixel;  ///< empty: the one that differs most
  std::uint32_t sample = 0;
};

struct ShrinkArguments {
  double shrinkSeconds = 60;  ///< time limit for removing parts of what fails
};

struct RepeatArguments {
  std::uint32_t repeats = 3;  ///< runs of each variant of a benchmark
};

// Targets of reports: a file, "-" for stdout, empty for none.

struct JsonArguments {
  std::string json;
};
struct JunitArguments {
  std::string junit;
};
struct MarkdownArguments {
  std::string markdown;
};
struct SvgArguments {
  std::string svg;
};
struct WrittenSceneArguments {
  std::string generatedFile = "-";
};

}  // namespace candela::cli
