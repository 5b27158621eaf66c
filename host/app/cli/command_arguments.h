// The arguments of each command.
#pragma once
#include <concepts>
#include <type_traits>
#include <variant>

#include "host/app/cli/arguments.h"
#include "host/app/view/shown_layer.h"
#include "host/app/view/view_state.h"
#include "host/base/tcp_client.h"
#include "host/drivers/conformance/picture_test.h"
#include "host/job/job.h"

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
  report = 131072,
  kernels = 262144
};

struct RenderArguments : TracingArguments,
                         SequenceArguments,
                         ImageFileArguments,
                         DenoisingArguments,
                         StrictArguments,
                         JsonArguments {
  static constexpr Command command = Command::render;
  job::FilmPolicy film;
  std::optional<ServerAddress> displayServer;  ///< that shows the image while it is computed
  bool printStatistics = false;
};

struct DevicesArguments : GeneralArguments, DeviceArguments, JsonArguments {
  static constexpr Command command = Command::devices;
};

struct CheckArguments : SceneArguments, JsonArguments {
  static constexpr Command command = Command::check;
};

struct CompareArguments : TracingArguments, PictureArguments, VerdictArguments, StrictArguments, JsonArguments {
  static constexpr Command command = Command::compare;
  std::vector<std::string> others;  ///< renders with which `files` are compared as sets; empty: two images, or a scene
  bool paired = false;              ///< of both sets, renders with equal indices belong together
  std::filesystem::path othersVariance;        ///< variances of one sample, for a single one of `others`; or empty
  std::optional<std::uint32_t> othersSamples;  ///< per pixel, of a single one of `others`; empty: the file states them
  std::optional<std::uint32_t> setSamples;     ///< per pixel, of each of `files`; empty: the files state them
  std::optional<double> tolerance;             ///< maximum relMSE that passes
  std::vector<std::string> channels;           ///< that are compared; empty: all but statistics
  std::filesystem::path differenceFile;
  std::filesystem::path flipFile;
};

struct GenerateArguments : GeneralArguments, WrittenSceneArguments {
  static constexpr Command command = Command::generate;
  std::optional<std::uint32_t> size;  ///< empty: the default of the kind
};

struct BenchArguments : TracingArguments, RepeatArguments, JsonArguments, MarkdownArguments, SvgArguments {
  static constexpr Command command = Command::bench;
  std::vector<std::string> sweeps;  ///< in the notation of sweepOver()
  std::uint32_t errorPictures = 0;  ///< with which the error in equal time is measured; 0: it is not
  double threshold = 0.05;          ///< fraction of its speed that a row may lose
};

struct KernelsArguments : TracingArguments, JsonArguments, MarkdownArguments {
  static constexpr Command command = Command::kernels;
  bool all = false;         ///< kernels that a render would use only with another --kernel, too
  double threshold = 0.05;  ///< fraction by which a figure may become worse
};

struct VerifyArguments : TracingArguments, VerdictArguments, StrictArguments, JsonArguments, JunitArguments {
  static constexpr Command command = Command::verify;
  bool explain = false;  ///< the pixel that differs most
};

struct BoxesArguments : SceneArguments, RequestArguments, WrittenSceneArguments {
  static constexpr Command command = Command::boxes;
  std::optional<std::uint32_t> depth;  ///< level of a BVH, 0 for the root; empty: all levels
};

struct ExplainArguments : TracingArguments, SampleArguments, JsonArguments {
  static constexpr Command command = Command::explain;
};

struct TuneArguments : SceneArguments, OpenDeviceArguments, RepeatArguments, JsonArguments, MarkdownArguments {
  static constexpr Command command = Command::tune;
  std::optional<render::Extent> size;        ///< of the image; empty: chosen by timing
  std::optional<std::uint32_t> sampleCount;  ///< per pixel; empty: chosen by timing
  bool dryRun = false;                       ///< store nothing
};

struct DoctorArguments : GeneralArguments, DeviceArguments, JsonArguments {
  static constexpr Command command = Command::doctor;
};

struct FilmArguments : GeneralArguments, MemoryArguments, ImageFileArguments, JsonArguments {
  static constexpr Command command = Command::film;
};

struct MergeArguments : GeneralArguments, MemoryArguments, JsonArguments {
  static constexpr Command command = Command::merge;
  std::filesystem::path output;  ///< film file
  bool mixedDevices = false;
  bool partial = false;
};

/// The cases that run, and the files with the expectations.
struct ConformanceArguments : GeneralArguments, DeviceArguments, ShrinkArguments, JsonArguments, JunitArguments {
  static constexpr Command command = Command::conformance;
  bool variants = false;                         ///< the cases are kernels against variants of them
  bool compileOnly = false;                      ///< compile the pipelines of the cases, and run nothing
  bool list = false;                             ///< print the names of the cases, and run none
  std::vector<std::string> cases;                ///< patterns of their names; empty: all
  conformance::PictureTest pictures;             ///< how cases that render pictures are tested
  std::optional<std::uint32_t> jobs;             ///< child processes at a time; empty: one per core
  std::optional<std::uint32_t> shuffle;          ///< seed of the order; empty: the order of the list
  double timeout = 60;                           ///< for each case, in seconds
  std::vector<std::filesystem::path> baselines;  ///< empty: every case is expected to pass
  std::vector<std::filesystem::path> skips;
  std::vector<std::filesystem::path> flakes;
  std::string csv;                 ///< like `json`
  std::filesystem::path captures;  ///< folder for captures of cases that fail; empty for none
};

struct CaptureArguments : TracingArguments, SampleArguments, ShrinkArguments {
  static constexpr Command command = Command::capture;
  std::filesystem::path folder;  ///< that is written
  std::string expect;            ///< selector of a device; empty: the reference tracer, or the host for a case
};

struct DenoiseArguments : GeneralArguments,
                          MemoryArguments,
                          OpenDeviceArguments,
                          ImageFileArguments,
                          DenoisingArguments {
  static constexpr Command command = Command::denoise;
};

struct ViewArguments : TracingArguments, PictureArguments, JsonArguments {
  static constexpr Command command = Command::view;
  view::Mode mode = view::Mode::device;
  view::ShownLayer layer;
};

struct ReportArguments : GeneralArguments, MarkdownArguments, SvgArguments {
  static constexpr Command command = Command::report;
};

/// The arguments of a command that renders scenes.
using TracingCommand = std::variant<RenderArguments, CompareArguments, BenchArguments, VerifyArguments,
                                    ExplainArguments, CaptureArguments, ViewArguments, KernelsArguments>;

/// The arguments of any command.
using Arguments = std::variant<RenderArguments, DevicesArguments, CheckArguments, CompareArguments, GenerateArguments,
                               BenchArguments, VerifyArguments, BoxesArguments, ExplainArguments, TuneArguments,
                               DoctorArguments, FilmArguments, MergeArguments, ConformanceArguments, CaptureArguments,
                               DenoiseArguments, ViewArguments, ReportArguments, KernelsArguments>;

/// Returns the arguments of a command with all options at their defaults.
Arguments defaultArguments(Command command);

/// Returns the command that has these arguments.
Command commandOf(const Arguments& arguments);

/// The commands whose arguments have a part, or are it: a sum of Command values.
template <class Part>
inline constexpr unsigned commandsWith = []<class... Commands>(const std::variant<Commands...>*) {
  return ((std::derived_from<Commands, Part> ? static_cast<unsigned>(Commands::command) : 0u) | ...);
}(static_cast<const Arguments*>(nullptr));

/// Returns a part of `arguments`, which are Arguments or const Arguments; null if the command lacks it.
template <class Part, class SomeArguments>
auto* findPart(SomeArguments& arguments) {
  using Found = std::conditional_t<std::is_const_v<SomeArguments>, const Part, Part>;
  return std::visit(
      [](auto& command) -> Found* {
        if constexpr (std::derived_from<std::remove_cvref_t<decltype(command)>, Part>) return &command;
        return nullptr;
      },
      arguments);
}

/// Returns the same as a reference. Throws std::bad_variant_access if the command lacks it.
template <class Part, class SomeArguments>
auto& partOf(SomeArguments& arguments) {
  auto* const part = findPart<Part>(arguments);
  if (part == nullptr) throw std::bad_variant_access();
  return *part;
}

}  // namespace candela::cli
