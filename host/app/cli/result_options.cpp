// Options of the results of renders: image and film files, comparison, verification and explanation.
#include <fmt/ranges.h>

#include "host/app/cli/option_groups.h"
#include "host/app/cli/option_kinds.h"

namespace candela::cli {
namespace {

const std::vector<std::pair<std::string, image::ToneMap>> kToneMaps{
    {"none", image::ToneMap::none},          {"srgb", image::ToneMap::srgb}, {"aces", image::ToneMap::aces},
    {"aces-hill", image::ToneMap::acesHill}, {"agx", image::ToneMap::agx},   {"pbr-neutral", image::ToneMap::neutral},
    {"neutral", image::ToneMap::neutral}};
const std::vector<std::pair<std::string, verify::LightTestMethod>> kLightTests{
    {"paired", verify::LightTestMethod::paired}, {"independent", verify::LightTestMethod::independent}};

// A flag with an optional value.
template <class Command>
Option denoiseFlag(const Row& row) {
  Option option = flag<Command>(
      row, [](auto& a) -> auto& { return a.denoise; });
  option.expected = "no value or oidn";
  option.apply = [](Arguments& arguments, const std::string& word) {
    auto& denoising = partOf<DenoisingArguments>(arguments);
    denoising.denoise = true;
    denoising.denoisesByOidn = word == kOidn;
    return word == "true" || denoising.denoisesByOidn;
  };
  option.show = [](const Arguments& arguments) {
    const auto& denoising = partOf<DenoisingArguments>(arguments);
    return std::vector<std::string>(denoising.denoise ? 1 : 0, denoising.denoisesByOidn ? kOidn : "on");
  };
  return option;
}

}  // namespace

// NOLINTBEGIN: each option is one row of any length.
// clang-format off
std::vector<Option> outputOptions() {
  constexpr OptionGroup kGroup = OptionGroup::output;
  return {
    paths<ImageFileArguments>({"-o,--output", kGroup, "image file (.png, .jpg, .hdr, .pfm or .exr); `-`: a PNG file to stdout, `-.exr`: an EXR file, and so on; repeatable"}, "FILE",
          [](auto& a) -> auto& { return a.outputs; }),
    valued<TracingArguments, kLayered>({"--aov", kGroup, fmt::format("layers to store beside the image in EXR files and films, separated by commas: {}; `id` and `material` are short names of the last two, and `all` means every layer", fmt::join(image::layerNames(), ", "))},
           layerList(), [](auto& a) -> auto& { return a.request.image.layers; }),
    valued<RenderArguments>({"--display-server", kGroup, "show the image, while it is rendered, in the viewer tev at this address (tev's default port: 14158)"},
           orAbsent(serverAddress(), "none"), [](auto& a) -> auto& { return a.displayServer; }),
    denoiseFlag<RenderArguments>({"--denoise", kGroup, "denoise the images by the statistics of their pixels, or with `--denoise oidn` by Open Image Denoise, if it is installed; the film of --checkpoint is stored without denoising, with the sums that `candela denoise` needs"}),
    denoiseFlag<DenoiseArguments>({"--denoise", kGroup, "`--denoise oidn`: by Open Image Denoise instead of the statistics of pixels"}),
    valued<PictureArguments>({"--tonemap", kGroup, "tone curve of 8-bit files and of FLIP; `none`: linear, clipped; without this option, the integrators `depth` and `cost` use false colours"},
           orAbsent(choice(kToneMaps), "srgb"), [](auto& a) -> auto& { return a.toneMap; }),
    valued<PictureArguments>({"--exposure", kGroup, "exposure of 8-bit files and of FLIP in stops; each stop doubles the brightness; `auto`: the image's geometric mean becomes 0.18"},
           orAbsent(realNumber<float>("STOPS", -64, 64), "auto"), [](auto& a) -> auto& { return a.exposure; }),
  };
}

std::vector<Option> filmOptions() {
  constexpr OptionGroup kGroup = OptionGroup::film;
  return {
    path<RenderArguments>({"--checkpoint", kGroup, "film file from which the render can be resumed; written during the render, when it is stopped, on SIGUSR1, and at the end"}, "FILE", [](auto& a) -> auto& { return a.film.checkpoint; }),
    valued<RenderArguments>({"--checkpoint-every", kGroup, "minimum time between two writes of the film, which also take at most 1 % of the time"},
           duration(0), [](auto& a) -> auto& { return a.film.checkpointEvery; }),
    path<RenderArguments>({"--resume", kGroup, "resume the render of a film file, up to --spp samples per pixel; of a sequence, continue with the frames that are missing among its films, or among its pictures if the pattern is that of -o"}, "FILE", [](auto& a) -> auto& { return a.film.resume; }),
    flag<RenderArguments>({"--resume-anyway", kGroup, "resume although scene, settings or device differ; the film is marked as mixed"},
         [](auto& a) -> auto& { return a.film.resumeAnyway; }),
    valued<RenderArguments>({"--time-limit", kGroup, "stop after this time, as Ctrl-C does"},
           orAbsent(duration(0), "none"), [](auto& a) -> auto& { return a.film.timeLimit; }),
    valued<RenderArguments>({"--samples", kGroup, "render samples A to B - 1 of the --spp of each pixel"},
           orAbsent(range<render::SampleRange>(render::kMaxSampleCount), "all"), [](auto& a) -> auto& { return a.film.samples; }),
    valued<RenderArguments>({"--crop", kGroup, "render a window: its left column, top row, width and height in pixels of the full image"},
           orAbsent(window(image::kMaxImageSide), "the scene's, else the image"), [](auto& a) -> auto& { return a.request.crop; }),
    path<MergeArguments>({"-o,--output", kGroup, "for `merge`: the film file that is written"}, "FILE", [](auto& a) -> auto& { return a.output; }),
    flag<MergeArguments>({"--mixed-devices", kGroup, "merge films of different devices; the film is marked as mixed"},
         [](auto& a) -> auto& { return a.mixedDevices; }),
    flag<MergeArguments>({"--partial", kGroup, "write the film although samples are missing"}, [](auto& a) -> auto& { return a.partial; }),
  };
}

std::vector<Option> comparisonOptions() {
  constexpr OptionGroup kGroup = OptionGroup::comparison;
  Option with = list<CompareArguments>({"--with", kGroup, "one render or more by any renderer, with which those before the option are compared: whether both sets show the same light, by a permutation test"},
           "FILE", "a path", [](auto& a) -> auto& { return a.others; });
  with.takesSeveral = true;
  return {
    with,
    flag<CompareArguments>({"--paired", kGroup, "with --with: the first renders of both sets belong together, for example because they have the same seed, and so do the second, and so on"},
         [](auto& a) -> auto& { return a.paired; }),
    path<CompareArguments>({"--with-variance", kGroup, "variances of one sample, for the single picture of --with, in the form of Mitsuba's references; EXR files of Candela and of Mitsuba's integrator `moment` contain them"}, "FILE", [](auto& a) -> auto& { return a.othersVariance; }),
    valued<CompareArguments>({"--with-spp", kGroup, "samples per pixel of the single picture of --with, if its variances are used"},
           orAbsent(wholeNumber(2, render::kMaxSampleCount), "that of the file"), [](auto& a) -> auto& { return a.othersSamples; }),
    valued<CompareArguments>({"--set-spp", kGroup, "samples per pixel of each render that is compared with such a picture"},
           orAbsent(wholeNumber(1, render::kMaxSampleCount), "that of the files"), [](auto& a) -> auto& { return a.setSamples; }),
    valued<CompareArguments>({"--tolerance", kGroup, "maximum relMSE at which two images pass, by their colours and by each other channel; ids must be equal"},
           orAbsent(realNumber<double>("T", 0, 1e30), ""), [](auto& a) -> auto& { return a.tolerance; }),
    valued<CompareArguments>({"--channels", kGroup, "channels to compare, separated by commas: R, G, B, A, Z, a layer such as albedo or N, or one of its channels (default: all that both images have, except statistics)"},
           nameList("NAMES", "names of channels, separated by commas"), [](auto& a) -> auto& { return a.channels; }),
    valued<CompareArguments>({"--alpha", kGroup, "false-alarm probability of the test for equal light, with --with at least 1e-6; without --alpha and --tolerance, two images are tested if both have variances (EXR files of `candela render`)"},
           fraction("A", 1e-12, 0.5), [](auto& a) -> auto& { return a.verification.alpha; }),
    valued<CompareArguments>({"--bias", kGroup, "fraction of the image mean that the test for equal light may overlook; if rounding or noise may hide more, the verdict is not decided"},
           orAbsent(fraction("FRACTION", 1e-7, 1), "1 %"), [](auto& a) -> auto& { return a.verification.bias; }),
    path<CompareArguments>({"--diff", kGroup, "write a picture of the differences: orange where A is brighter, blue where A is darker"}, "FILE", [](auto& a) -> auto& { return a.differenceFile; }),
    path<CompareArguments>({"--flip", kGroup, "write a picture of the FLIP errors"}, "FILE", [](auto& a) -> auto& { return a.flipFile; }),
  };
}

std::vector<Option> verificationOptions() {
  constexpr OptionGroup kGroup = OptionGroup::verification;
  return {
    valued<VerifyArguments>({"--alpha", kGroup, "false-alarm probability of the whole run"},
           fraction("A", 1e-12, 0.5), [](auto& a) -> auto& { return a.verification.alpha; }),
    valued<VerifyArguments>({"--bias", kGroup, "relative difference of the image means that the test must detect; the run ends when it would have been detected, and if rounding or noise may hide more, the verdict is not decided"},
           orAbsent(fraction("FRACTION", 1e-7, 1), "1 %, and the run continues to 0.05 % or 32 samples per pixel; 0.5 % with --test independent"), [](auto& a) -> auto& { return a.verification.bias; }),
    valued<VerifyArguments>({"--test", kGroup, "`paired`: both sides draw the same random numbers, and their differences are tested; `independent`: the means of renders with different random numbers are tested, which takes many more samples"},
           choice(kLightTests), [](auto& a) -> auto& { return a.verification.method; }),
    valued<VerifyArguments>({"--time-limit", kGroup, "end with fewer samples if the test would take longer than about this time"},
           orAbsent(duration(0), "none"), [](auto& a) -> auto& { return a.verification.timeLimit; }),
    flag<VerdictArguments>({"--allow-undecided", kGroup, "a verdict that is not decided is a success: exit code 0, and a skipped case in JUnit XML"},
         [](auto& a) -> auto& { return a.allowUndecided; }),
    valued<JunitArguments>({"--junit", kGroup, "write the results as JUnit XML; `-`: to stdout"},
           text("FILE", "a file, or -"), [](auto& a) -> auto& { return a.junit; }),
    flag<VerifyArguments>({"--explain", kGroup, "after the verdict, explain the pixel that differs most, as `candela explain` does"},
         [](auto& a) -> auto& { return a.explain; }),
  };
}

std::vector<Option> explanationOptions() {
  constexpr OptionGroup kGroup = OptionGroup::explanation;
  return {
    valued<ExplainArguments>({"--pixel", kGroup, "pixel whose sample is traced; 0,0 is the top left"},
           orAbsent(pixelPosition(image::kMaxImageSide - 1), "the pixel that differs most"), [](auto& a) -> auto& { return a.pixel; }),
    valued<SampleArguments>({"--sample", kGroup, "index of the pixel's sample, from 0"},
           wholeNumber(0, render::kMaxSampleCount - 1), [](auto& a) -> auto& { return a.sample; }),
  };
}
// clang-format on
// NOLINTEND

}  // namespace candela::cli
