// Options of bench, tune, view and the commands that write scenes, and options of all commands.
#include <fmt/format.h>

#include "host/app/cli/option_groups.h"
#include "host/app/cli/option_kinds.h"

namespace candela::cli {
namespace {

constexpr std::uint32_t kMaxRepeats = 1000;
constexpr std::uint32_t kMaxErrorPictures = 1000;
const std::vector<std::pair<std::string, view::Mode>> kModes{{"device", view::Mode::device},
                                                             {"reference", view::Mode::reference},
                                                             {"split", view::Mode::split},
                                                             {"difference", view::Mode::difference}};

// The picture, the layers by their names of --aov, and short names of the mattes.
Notation<view::ShownLayer> shownLayer() {
  std::vector<std::pair<std::string, view::ShownLayer>> names{{std::string(view::shownName({})), std::nullopt}};
  for (const image::Layer layer : view::shownLayers()) names.emplace_back(view::shownName(layer), layer);
  for (const auto& [alias, layer] : kLayerAliases) names.emplace_back(alias, layer);
  Notation<view::ShownLayer> notation = choice(names);
  notation.metavar = "LAYER";
  return notation;
}

std::string shownLayerText() {
  std::string text;
  for (const image::Layer layer : view::shownLayers())
    text += (text.empty() ? "" : ", ") + std::string(view::shownName(layer));
  return text;
}

}  // namespace

// NOLINTBEGIN: each option is one row of any length.
// clang-format off
std::vector<Option> benchmarkOptions() {
  constexpr OptionGroup kGroup = OptionGroup::benchmark;
  return {
    valued<RepeatArguments>({"--repeat", kGroup, "runs of each variant, interleaved; the median is reported"},
           wholeNumber(1, kMaxRepeats), [](auto& a) -> auto& { return a.repeats; }),
    paths<BenchArguments>({"--sweep", kGroup, "for scenes: measure each of these values of an option (named without its dashes); if repeated, all combinations"}, "NAME=V,V,...",
          [](auto& a) -> auto& { return a.sweeps; }),
    valued<BenchArguments>({"--error", kGroup, "for scenes: measure the error in equal time with this number of pictures of other seeds, against a reference of 8 times as many samples in each of as many pictures; 0: estimate the relMSE from two pictures"},
           wholeNumber(0, kMaxErrorPictures), [](auto& a) -> auto& { return a.errorPictures; }),
    valued<BenchArguments>({"--threshold", kGroup, "for `compare`: fraction of its speed that a row of the report may lose"},
           fraction("FRACTION", 0, 1), [](auto& a) -> auto& { return a.threshold; }),
    valued<MarkdownArguments>({"--markdown", kGroup, "write the table as Markdown; `-`: to stdout"},
           text("FILE", "a file, or -"), [](auto& a) -> auto& { return a.markdown; }),
    valued<SvgArguments>({"--svg", kGroup, "for scenes and `report`: write a chart of samples per second as SVG; `-`: to stdout"},
           text("FILE", "a file, or -"), [](auto& a) -> auto& { return a.svg; }),
  };
}

std::vector<Option> kernelOptions() {
  constexpr OptionGroup kGroup = OptionGroup::kernels;
  return {
    flag<KernelsArguments>({"--all-kernels", kGroup, "report the megakernel and the wavefront kernels, whichever a render would use"},
         [](auto& a) -> auto& { return a.all; }),
    valued<KernelsArguments>({"--threshold", kGroup, "for `compare`: fraction by which a figure may become worse"},
           fraction("FRACTION", 0, 1), [](auto& a) -> auto& { return a.threshold; }),
  };
}

std::vector<Option> tuningOptions() {
  constexpr OptionGroup kGroup = OptionGroup::tuning;
  return {
    valued<TuneArguments>({"--size", kGroup, "image size in pixels; `auto`: chosen by timing, at most the scene's"},
           orAbsent(extent("WxH", image::kMaxImageSide), "auto"), [](auto& a) -> auto& { return a.size; }),
    valued<TuneArguments>({"--spp", kGroup, "samples per pixel; `auto`: chosen by timing"},
           orAbsent(wholeNumber(0, render::kMaxSampleCount), "auto"), [](auto& a) -> auto& { return a.sampleCount; }),
    flag<TuneArguments>({"--dry-run", kGroup, "measure and report, but store nothing"}, [](auto& a) -> auto& { return a.dryRun; }),
  };
}

std::vector<Option> generationOptions() {
  constexpr OptionGroup kGroup = OptionGroup::generation;
  return {
    valued<WrittenSceneArguments>({"-o,--output", kGroup, "scene file; `-`: stdout"},
           text("FILE", "a file, or -"), [](auto& a) -> auto& { return a.generatedFile; }),
    valued<GenerateArguments>({"--size", kGroup, "size of the scene; each kind has its own range"},
           orAbsent(wholeNumber(0, kAnySize), "the kind's"), [](auto& a) -> auto& { return a.size; }),
    valued<BoxesArguments>({"--depth", kGroup, "draw one level of the BVH, and the leaves above it; the root is level 0"},
           orAbsent(wholeNumber(0, kAnySize), "all"), [](auto& a) -> auto& { return a.depth; }),
  };
}

std::vector<Option> viewingOptions() {
  constexpr OptionGroup kGroup = OptionGroup::viewing;
  return {
    valued<ViewArguments>({"--spp", kGroup, "samples per pixel of the finished picture; 0: one ray through the centre of each pixel"},
           orAbsent(wholeNumber(0, render::kMaxSampleCount), "4096"), [](auto& a) -> auto& { return a.request.sampleCount; }),
    valued<ViewArguments>({"--show", kGroup, "what the window shows first: the image of one tracer, both images side by side, or their difference"},
           choice(kModes), [](auto& a) -> auto& { return a.mode; }),
    valued<ViewArguments>({"--layer", kGroup, fmt::format("layer that the window shows first instead of the picture: {}; `id` and `material` are short names of the mattes", shownLayerText())},
           shownLayer(), [](auto& a) -> auto& { return a.layer; }),
  };
}

std::vector<Option> generalOptions() {
  constexpr OptionGroup kGroup = OptionGroup::general;
  return {
    flag<RenderArguments>({"--stats", kGroup, "print times, numbers of rays and the settings in use to stdout"}, [](auto& a) -> auto& { return a.printStatistics; }),
    valued<JsonArguments>({"--json", kGroup, "write the report as JSON; `-`: to stdout"},
           text("FILE", "a file, or -"), [](auto& a) -> auto& { return a.json; }),
    valued<DevicesArguments>({"--device", kGroup, "for `candela devices`: list one device alone, by its index or a part of its name"},
           text("N|SUBSTRING", "a device", "all"), [](auto& a) -> auto& { return a.device; }),
    flag<StrictArguments>({"--strict", kGroup, "exit with code 3 if a sample is not finite, negative or too bright; files are still written"},
         [](auto& a) -> auto& { return a.strict; }),
    path<VerdictArguments>({"--report", kGroup, "write an HTML page with the images, maps of their differences, figures and the verdict"}, "FILE",
         [](auto& a) -> auto& { return a.report; }),
    flag<GeneralArguments>({"-q,--quiet", kGroup, "print only errors"}, [](auto& a) -> auto& { return a.quiet; }),
    flag<GeneralArguments>({"-v,--verbose", kGroup, "print details"}, [](auto& a) -> auto& { return a.verbose; }),
    flag<GeneralArguments>({"--version", kGroup, "print the version"}, [](auto& a) -> auto& { return a.version; }),
    flag<GeneralArguments>({"-h,--help", kGroup, "print this help"}, [](auto& a) -> auto& { return a.help; }),
  };
}
// clang-format on
// NOLINTEND

}  // namespace candela::cli
