// The option table: one row per option.
#include "host/cli/option_table.h"

#include <limits>

#include "host/cli/option_kinds.h"

namespace candela::cli {
namespace {

constexpr unsigned kRender = static_cast<unsigned>(Command::render);
constexpr unsigned kDevices = static_cast<unsigned>(Command::devices);
constexpr unsigned kCheck = static_cast<unsigned>(Command::check);
constexpr unsigned kCompare = static_cast<unsigned>(Command::compare);
constexpr unsigned kGenerate = static_cast<unsigned>(Command::generate);
constexpr unsigned kBench = static_cast<unsigned>(Command::bench);
constexpr unsigned kVerify = static_cast<unsigned>(Command::verify);
constexpr unsigned kBoxes = static_cast<unsigned>(Command::boxes);
constexpr unsigned kExplain = static_cast<unsigned>(Command::explain);
constexpr unsigned kTune = static_cast<unsigned>(Command::tune);
constexpr unsigned kDoctor = static_cast<unsigned>(Command::doctor);
constexpr unsigned kFilm = static_cast<unsigned>(Command::film);
constexpr unsigned kMerge = static_cast<unsigned>(Command::merge);
constexpr unsigned kTracing = kRender | kCompare | kBench | kVerify | kExplain;
constexpr unsigned kReadingScenes = kTracing | kCheck | kBoxes | kTune;
constexpr unsigned kSurrounding = kTracing | kCheck | kTune;
constexpr unsigned kReporting = kRender | kDevices | kCheck | kCompare | kBench | kVerify | kExplain | kTune | kDoctor |
                                kFilm | kMerge;
constexpr unsigned kAll = kReporting | kGenerate | kBoxes;

constexpr std::uint32_t kMaxSamples = 1u << 30;
constexpr std::uint32_t kMaxSegments = 1u << 20;
constexpr std::uint32_t kMaxSide = 65535;
constexpr std::uint32_t kMaxWorkgroupSide = 1024;
constexpr std::uint32_t kMaxThreads = 1024;
constexpr std::uint32_t kMaxRepeats = 1000;
constexpr float kMinGridDensity = 0.0625f;
constexpr float kMaxGridDensity = 64;
constexpr std::uint32_t kAnySize = std::numeric_limits<std::uint32_t>::max();  // the kind's range is checked later
constexpr float kMinReach = 1e-30f;
constexpr float kMaxReach = 1e30f;

const std::vector<std::pair<std::string, bool>> kOnOff{{"on", true}, {"off", false}};
const std::vector<std::pair<std::string, render::SamplerKind>> kSamplers{
    {"independent", render::SamplerKind::independent},
    {"stratified", render::SamplerKind::stratified},
    {"sobol", render::SamplerKind::sobol}};
const std::vector<std::pair<std::string, render::Integrator>> kIntegrators{
    {"path", render::Integrator::path},     {"whitted", render::Integrator::whitted},
    {"ao", render::Integrator::ao},         {"normal", render::Integrator::normal},
    {"albedo", render::Integrator::albedo}, {"depth", render::Integrator::depth},
    {"id", render::Integrator::id},         {"cost", render::Integrator::cost}};
const std::vector<std::pair<std::string, verify::LightTestMethod>> kLightTests{
    {"paired", verify::LightTestMethod::paired}, {"independent", verify::LightTestMethod::independent}};
const std::vector<std::pair<std::string, image::ToneMap>> kToneMaps{
    {"none", image::ToneMap::none}, {"srgb", image::ToneMap::srgb},           {"aces", image::ToneMap::aces},
    {"agx", image::ToneMap::agx},   {"pbr-neutral", image::ToneMap::neutral}, {"neutral", image::ToneMap::neutral}};

std::string defaultDepths() {
  return fmt::format("{}; whitted: {}", defaultMaxDepth(render::Integrator::path),
                     defaultMaxDepth(render::Integrator::whitted));
}

// NOLINTBEGIN: each option is one row of any length.
// clang-format off
std::vector<Option> imageOptions() {
  constexpr OptionGroup kGroup = OptionGroup::image;
  const std::string defaultSamples = fmt::format("the scene's `spp`, else {}", render::RenderSettings{}.image.sampleCount);
  return {
    valued({"--spp", kRender | kCompare | kBench | kExplain, kGroup, "samples per pixel; 0: one ray through the centre of each pixel, without antialiasing"},
           orAbsent(wholeNumber(0, kMaxSamples), defaultSamples), [](auto& a) -> auto& { return a.sampleCount; }),
    valued({"--seed", kTracing, kGroup, "seed of the random numbers"},
           wholeNumber(0, std::numeric_limits<std::uint32_t>::max()), [](auto& a) -> auto& { return a.settings.image.seed; }),
    valued({"--size", kTracing, kGroup, "image size in pixels"},
           orAbsent(extent("WxH", kMaxSide), "the scene's"), [](auto& a) -> auto& { return a.size; }),
    valued({"--max-depth", kTracing, kGroup, "maximum number of rays in a path, counting the camera ray"},
           orAbsent(wholeNumber(1, kMaxSegments), defaultDepths()), [](auto& a) -> auto& { return a.maxDepth; }),
    valued({"--rr-start", kTracing, kGroup, "number of path vertices before Russian roulette starts"},
           wholeNumber(0, kMaxSegments), [](auto& a) -> auto& { return a.settings.image.rouletteStart; }),
    valued({"--integrator", kTracing, kGroup, "`path`: path tracing; `whitted`: Whitted ray tracing; the others: views of what camera rays hit"},
           choice(kIntegrators), [](auto& a) -> auto& { return a.settings.image.integrator; }),
    valued({"--ao-distance", kTracing, kGroup, "maximum distance of occluders for `ao`; `auto`: a quarter of the distance from eye to target"},
           orAbsent(realNumber<float>("D", kMinReach, kMaxReach), "auto"), [](auto& a) -> auto& { return a.settings.image.aoDistance; }),
    valued({"--nee", kTracing, kGroup, "next-event estimation: sample the lights at every path vertex"},
           choice(kOnOff), [](auto& a) -> auto& { return a.settings.image.nextEventEstimation; }),
    valued({"--sampler", kTracing, kGroup, "how random numbers are generated"},
           choice(kSamplers), [](auto& a) -> auto& { return a.settings.image.sampler; }),
    valued({"--filter", kTracing, kGroup, "pixel filter"},
           choice<render::FilterKind>({{"box", render::FilterKind::box}, {"tent", render::FilterKind::tent}}), [](auto& a) -> auto& { return a.settings.image.filter; }),
    valued({"--lens", kTracing, kGroup, "shape of the lens, if the scene's camera has an aperture"},
           choice<render::LensKind>({{"disc", render::LensKind::disc}, {"square", render::LensKind::square}}), [](auto& a) -> auto& { return a.settings.image.lens; }),
    valued({"--pixel-origin", kTracing, kGroup, "points through which camera rays pass without jitter: the centres of the pixels, or the corners of a grid of (W-1)x(H-1) cells"},
           choice<render::PixelOrigin>({{"centre", render::PixelOrigin::centre}, {"corner", render::PixelOrigin::corner}}), [](auto& a) -> auto& { return a.settings.image.pixelOrigin; }),
    valued({"--light-size", kTracing, kGroup, "for `whitted`: side of the square area lights that replace point lights; 0: point lights"},
           realNumber<float>("S", 0, 1e30f), [](auto& a) -> auto& { return a.settings.image.lightSize; }),
    valued({"--clamp-indirect", kRender | kCompare | kBench | kExplain, kGroup, "maximum of what light that was scattered twice or more contributes to a sample, against fireflies; the image is then too dark, and says so; `off`: unbiased"},
           orAbsent(realNumber<float>("V", 1e-6f, 1e6f), "off"), [](auto& a) -> auto& { return a.settings.image.indirectLimit; }),
    flag({"--one-sided", kTracing, kGroup, "let rays pass through the backs of opaque polygons and planes, as in NFF"},
         [](auto& a) -> auto& { return a.settings.image.oneSided; }),
  };
}

std::vector<Option> sceneFileOptions() {
  constexpr OptionGroup kGroup = OptionGroup::sceneFile;
  return {
    flag({"--lenient", kReadingScenes, kGroup, "skip unknown statements and complete short ones, with warnings"},
         [](auto& a) -> auto& { return a.loadOptions.lenient; }),
    paths({"--allow-path", kReadingScenes, kGroup, "folder, besides the scene's own, from which a scene may read files; repeatable"}, "DIR",
          [](auto& a) -> auto& { return a.loadOptions.allowedPaths; }),
    valued({"--env", kSurrounding, kGroup, "environment that replaces the background: an equirectangular image (.hdr, .exr), `white`, or the daylight `sun:ELEVATION,AZIMUTH,TURBIDITY`"},
           text("FILE", "an environment", "none"), [](auto& a) -> auto& { return a.loadOptions.environment.source; }),
    valued({"--env-rotate", kSurrounding, kGroup, "rotation of the environment about the axis that points up, counterclockwise seen from above"},
           realNumber<double>("DEG", -360, 360), [](auto& a) -> auto& { return a.loadOptions.environment.rotation; }),
    valued({"--env-scale", kSurrounding, kGroup, "factor of the environment's radiance"},
           realNumber<double>("S", 0, 1e30), [](auto& a) -> auto& { return a.loadOptions.environment.scale; }),
    valued({"--camera", kReadingScenes, kGroup, "for glTF: name or index of the camera; `none`: a view that frames the model"},
           orAbsent(text("NAME|N", "a camera"), "the first, else none"), [](auto& a) -> auto& { return a.loadOptions.camera; }),
    valued({"--time", kReadingScenes, kGroup, "for glTF: time in the first animation, in seconds"},
           orAbsent(realNumber<double>("SECONDS", 0, 1e9), "the pose at rest"), [](auto& a) -> auto& { return a.loadOptions.time; }),
  };
}

std::vector<Option> executionOptions() {
  constexpr OptionGroup kGroup = OptionGroup::execution;
  return {
    valued({"--device", kTracing | kTune | kDoctor, kGroup, "`cpu` for the reference tracer, or the index or a part of the name of a device in `candela devices`"},
           text("cpu|N|SUBSTRING", "a device", "the best GPU"), [](auto& a) -> auto& { return a.device; }),
    valued({"--accel", kRender | kCompare | kBench | kExplain, kGroup, "acceleration structure"},
           orAbsent(choice<render::AccelKind>({{"none", render::AccelKind::none}, {"grid", render::AccelKind::grid}, {"bvh", render::AccelKind::bvh}}), "the scene's `accel`, else bvh"), [](auto& a) -> auto& { return a.accel; }),
    valued({"--bvh-split", kRender | kCompare | kBench | kBoxes | kExplain, kGroup, "how the nodes of a BVH are split: by the surface area heuristic, or at the midpoint of the longest axis"},
           choice<render::BvhSplit>({{"sah", render::BvhSplit::sah}, {"midpoint", render::BvhSplit::midpoint}}), [](auto& a) -> auto& { return a.settings.structure.bvhSplit; }),
    valued({"--bvh-quality", kRender | kCompare | kBench | kBoxes | kExplain, kGroup, "build quality of a device's SAH BVH: `fast` builds faster, `high` traces faster"},
           choice<render::BuildQuality>({{"fast", render::BuildQuality::fast}, {"default", render::BuildQuality::standard}, {"high", render::BuildQuality::high}}), [](auto& a) -> auto& { return a.settings.structure.bvhQuality; }),
    valued({"--layout", kTracing, kGroup, "nodes of a device's BVH: binary (bvh2), or compressed and 8-wide (cwbvh); `auto`: as tuned, else cwbvh, or bvh2 with midpoint splits"},
           choice<render::BvhLayout>({{"auto", render::BvhLayout::automatic}, {"bvh2", render::BvhLayout::bvh2}, {"cwbvh", render::BvhLayout::cwbvh}}), [](auto& a) -> auto& { return a.settings.structure.bvhLayout; }),
    valued({"--loads", kTracing, kGroup, "buffer type through which a device reads the scene; `auto`: as tuned, else texel if the scene fits"},
           choice<render::SceneLoads>({{"auto", render::SceneLoads::automatic}, {"texel", render::SceneLoads::texel}, {"storage", render::SceneLoads::storage}}), [](auto& a) -> auto& { return a.settings.execution.sceneLoads; }),
    valued({"--grid-density", kTracing, kGroup, "density M of a grid, which has about M^3 cells per primitive"},
           realNumber<float>("M", kMinGridDensity, kMaxGridDensity), [](auto& a) -> auto& { return a.settings.structure.gridDensity; }),
    valued({"--kernel", kTracing, kGroup, "one kernel that traces whole paths, or one kernel per stage; `auto`: as tuned, else megakernel"},
           choice<render::KernelKind>({{"auto", render::KernelKind::automatic}, {"megakernel", render::KernelKind::megakernel}, {"wavefront", render::KernelKind::wavefront}}), [](auto& a) -> auto& { return a.settings.execution.kernel; }),
    valued({"--workgroup", kTracing, kGroup, "workgroup size in invocations; `auto`: as tuned, else 8x8"},
           orAbsent(extent("XxY", kMaxWorkgroupSide), "auto"), [](auto& a) -> auto& { return a.settings.execution.workgroup; }),
    valued({"--tile", kTracing, kGroup, "size in pixels of the region that one dispatch processes; `auto`: chosen by timing"},
           orAbsent(extent("WxH", kMaxSide), "auto"), [](auto& a) -> auto& { return a.settings.execution.tile; }),
    valued({"--segments-per-dispatch", kTracing, kGroup, "maximum number of segments by which one dispatch advances a path; `auto`: chosen by timing"},
           orAbsent(wholeNumber(1, kMaxSegments), "auto"), [](auto& a) -> auto& { return a.settings.execution.segmentsPerDispatch; }),
    valued({"--hang-timeout", kTracing | kTune, kGroup, "time after which a device that has not finished its work counts as hung; 0s: never; `auto`: 50 times the longest dispatch and at least 10 s, or never on devices in software"},
           orAbsent(duration(0), "auto"), [](auto& a) -> auto& { return a.hangTimeout; }),
    valued({"--fallback", kRender, kGroup, "what finishes the render if the device fails for good: `cpu` for the reference tracer, which marks the film as mixed"},
           choice<Fallback>({{"none", Fallback::none}, {"cpu", Fallback::reference}}), [](auto& a) -> auto& { return a.fallback; }),
    valued({"--memory", kReadingScenes | kFilm | kMerge, kGroup, "memory that may be used; what needs more is refused before it is allocated"},
           orAbsent(byteCount(), "the machine's"), [](auto& a) -> auto& { return a.memory; }),
    flag({"--untuned", kTracing, kGroup, "ignore the results of `candela tune`"}, [](auto& a) -> auto& { return a.untuned; }),
    flag({"--no-cache", kTracing | kTune, kGroup, "neither read nor write compiled pipelines in the cache folder; the driver may have a cache of its own"},
         [](auto& a) -> auto& { return a.noCache; }),
    valued({"-t,--threads", kTracing, kGroup, "threads of the reference tracer; 0: one per core"},
           wholeNumber(0, kMaxThreads), [](auto& a) -> auto& { return a.settings.execution.threads; }),
  };
}

std::vector<Option> outputOptions() {
  constexpr OptionGroup kGroup = OptionGroup::output;
  return {
    paths({"-o,--output", kRender | kFilm, kGroup, "image file (.png, .jpg, .hdr, .pfm or .exr); repeatable"}, "FILE",
          [](auto& a) -> auto& { return a.outputs; }),
    valued({"--tonemap", kRender | kCompare | kFilm, kGroup, "tone curve of 8-bit files and of FLIP; `none`: linear, clipped; without this option, the integrators `depth` and `cost` use false colours"},
           choice(kToneMaps), [](auto& a) -> auto& { return a.display.toneMap; }),
    valued({"--exposure", kRender | kCompare | kFilm, kGroup, "exposure of 8-bit files and of FLIP in EV; each doubles the brightness; `auto`: the image's geometric mean becomes 0.18"},
           orAbsent(realNumber<float>("STOPS", -64, 64), "auto"), [](auto& a) -> auto& { return a.exposure; }),
  };
}

std::vector<Option> filmOptions() {
  constexpr OptionGroup kGroup = OptionGroup::film;
  return {
    path({"--checkpoint", kRender, kGroup, "film file that the render can go on from: written during the render, when it is stopped, on SIGUSR1, and at the end"}, "FILE", [](auto& a) -> auto& { return a.checkpoint; }),
    valued({"--checkpoint-every", kRender, kGroup, "minimum time between two writes of the film, which also take at most 1 % of the time"},
           duration(0), [](auto& a) -> auto& { return a.checkpointEvery; }),
    path({"--resume", kRender, kGroup, "go on from a film file, up to --spp"}, "FILE", [](auto& a) -> auto& { return a.resume; }),
    flag({"--resume-anyway", kRender, kGroup, "go on although scene, settings or device differ; the film is marked as mixed"},
         [](auto& a) -> auto& { return a.resumeAnyway; }),
    valued({"--time-limit", kRender, kGroup, "stop after this time, as Ctrl-C does"},
           orAbsent(duration(0), "none"), [](auto& a) -> auto& { return a.timeLimit; }),
    valued({"--samples", kRender, kGroup, "render samples A to B - 1 of the --spp of each pixel"},
           orAbsent(sampleRange(kMaxSamples), "all"), [](auto& a) -> auto& { return a.samples; }),
    valued({"--crop", kRender, kGroup, "render a window: its left column, top row, width and height in pixels of the full image"},
           orAbsent(window(kMaxSide), "the image"), [](auto& a) -> auto& { return a.settings.image.crop; }),
    path({"-o,--output", kMerge, kGroup, "for `merge`: the film file that is written"}, "FILE", [](auto& a) -> auto& { return a.mergedFilm; }),
    flag({"--mixed-devices", kMerge, kGroup, "merge films of different devices; the film is marked as mixed"},
         [](auto& a) -> auto& { return a.mixedDevices; }),
    flag({"--partial", kMerge, kGroup, "write the film although samples are missing"}, [](auto& a) -> auto& { return a.partial; }),
  };
}

std::vector<Option> comparisonOptions() {
  constexpr OptionGroup kGroup = OptionGroup::comparison;
  return {
    valued({"--tolerance", kCompare, kGroup, "maximum relMSE at which two images pass"},
           orAbsent(realNumber<double>("T", 0, 1e30), ""), [](auto& a) -> auto& { return a.tolerance; }),
    valued({"--alpha", kCompare, kGroup, "false-alarm probability of the test for equal light; without --alpha and --tolerance, the test runs if both images have variances (EXR files of `candela render`)"},
           share("A", 1e-12, 0.5), [](auto& a) -> auto& { return a.verification.alpha; }),
    path({"--diff", kCompare, kGroup, "write a picture of the differences: orange where A is brighter, blue where A is darker"}, "FILE", [](auto& a) -> auto& { return a.differenceFile; }),
    path({"--flip", kCompare, kGroup, "write a picture of the FLIP errors"}, "FILE", [](auto& a) -> auto& { return a.flipFile; }),
  };
}

std::vector<Option> verificationOptions() {
  constexpr OptionGroup kGroup = OptionGroup::verification;
  return {
    valued({"--alpha", kVerify, kGroup, "false-alarm probability of the whole run"},
           share("A", 1e-12, 0.5), [](auto& a) -> auto& { return a.verification.alpha; }),
    valued({"--bias", kVerify, kGroup, "relative difference of the image means that the test must detect"},
           orAbsent(share("FRACTION", 1e-7, 1), "0.05 %, or 3 times what rounding may cause; 0.5 % with --test independent"), [](auto& a) -> auto& { return a.verification.bias; }),
    valued({"--test", kVerify, kGroup, "`paired`: both sides draw the same random numbers, and their differences are tested; `independent`: the means of renders with different random numbers are tested, which takes many more samples"},
           choice(kLightTests), [](auto& a) -> auto& { return a.verification.method; }),
    valued({"--time-limit", kVerify, kGroup, "do not start another look at the images after this time"},
           orAbsent(duration(0), "none"), [](auto& a) -> auto& { return a.verification.timeLimit; }),
    valued({"--junit", kVerify, kGroup, "write the verdict as JUnit XML; `-`: to stdout"},
           text("FILE", "a file, or -"), [](auto& a) -> auto& { return a.junit; }),
    flag({"--explain", kVerify, kGroup, "after the verdict, explain the pixel that differs most, as `candela explain` does"},
         [](auto& a) -> auto& { return a.explain; }),
  };
}

std::vector<Option> explanationOptions() {
  constexpr OptionGroup kGroup = OptionGroup::explanation;
  return {
    valued({"--pixel", kExplain, kGroup, "pixel whose sample is traced; 0,0 is the top left"},
           orAbsent(pixelPlace(kMaxSide - 1), "the pixel that differs most"), [](auto& a) -> auto& { return a.pixel; }),
    valued({"--sample", kExplain, kGroup, "index of the pixel's sample, from 0"},
           wholeNumber(0, kMaxSamples - 1), [](auto& a) -> auto& { return a.sample; }),
  };
}

std::vector<Option> benchmarkOptions() {
  constexpr OptionGroup kGroup = OptionGroup::benchmark;
  return {
    valued({"--repeat", kBench | kTune, kGroup, "runs of each variant, interleaved; the median is reported"},
           wholeNumber(1, kMaxRepeats), [](auto& a) -> auto& { return a.repeats; }),
    paths({"--sweep", kBench, kGroup, "for scenes: measure each value of an option (named without its dashes); repeatable, for all combinations"}, "NAME=V,V,...",
          [](auto& a) -> auto& { return a.sweeps; }),
    valued({"--threshold", kBench, kGroup, "for `compare`: fraction of its speed that a row may lose"},
           share("FRACTION", 0, 1), [](auto& a) -> auto& { return a.threshold; }),
    valued({"--markdown", kBench | kTune, kGroup, "write the table as Markdown; `-`: to stdout"},
           text("FILE", "a file, or -"), [](auto& a) -> auto& { return a.markdown; }),
    valued({"--svg", kBench, kGroup, "for scenes: write a chart of samples per second as SVG; `-`: to stdout"},
           text("FILE", "a file, or -"), [](auto& a) -> auto& { return a.svg; }),
  };
}

std::vector<Option> tuningOptions() {
  constexpr OptionGroup kGroup = OptionGroup::tuning;
  return {
    valued({"--size", kTune, kGroup, "image size in pixels; `auto`: chosen by timing, at most the scene's"},
           orAbsent(extent("WxH", kMaxSide), "auto"), [](auto& a) -> auto& { return a.size; }),
    valued({"--spp", kTune, kGroup, "samples per pixel; `auto`: chosen by timing"},
           orAbsent(wholeNumber(0, kMaxSamples), "auto"), [](auto& a) -> auto& { return a.sampleCount; }),
    flag({"--dry-run", kTune, kGroup, "measure and report, but store nothing"}, [](auto& a) -> auto& { return a.dryRun; }),
  };
}

std::vector<Option> generationOptions() {
  constexpr OptionGroup kGroup = OptionGroup::generation;
  return {
    valued({"-o,--output", kGenerate | kBoxes, kGroup, "scene file; `-`: stdout"},
           text("FILE", "a file, or -"), [](auto& a) -> auto& { return a.generatedFile; }),
    valued({"--size", kGenerate, kGroup, "size of the scene; each kind has its own range"},
           orAbsent(wholeNumber(0, kAnySize), "the kind's"), [](auto& a) -> auto& { return a.generatedSize; }),
    valued({"--depth", kBoxes, kGroup, "draw one level of the BVH, and the leaves above it; the root is level 0"},
           orAbsent(wholeNumber(0, kAnySize), "all"), [](auto& a) -> auto& { return a.boxDepth; }),
  };
}

std::vector<Option> generalOptions() {
  constexpr OptionGroup kGroup = OptionGroup::general;
  return {
    flag({"--stats", kRender, kGroup, "print times, numbers of rays and the settings in use to stdout"}, [](auto& a) -> auto& { return a.printStatistics; }),
    valued({"--json", kReporting, kGroup, "write the report as JSON; `-`: to stdout"},
           text("FILE", "a file, or -"), [](auto& a) -> auto& { return a.json; }),
    flag({"--strict", kRender | kCompare | kVerify, kGroup, "exit with 3 if a sample is not finite, negative or too bright; files are still written"},
         [](auto& a) -> auto& { return a.strict; }),
    path({"--report", kCompare | kVerify, kGroup, "write an HTML page with the images, maps of their differences, figures and the verdict"}, "FILE",
         [](auto& a) -> auto& { return a.report; }),
    flag({"-q,--quiet", kAll, kGroup, "print only errors"}, [](auto& a) -> auto& { return a.quiet; }),
    flag({"-v,--verbose", kAll, kGroup, "print details"}, [](auto& a) -> auto& { return a.verbose; }),
    flag({"--version", kAll, kGroup, "print the version"}, [](auto& a) -> auto& { return a.version; }),
    flag({"-h,--help", kAll, kGroup, "print this help"}, [](auto& a) -> auto& { return a.help; }),
  };
}
// clang-format on
// NOLINTEND

}  // namespace

const std::vector<Option>& optionTable() {
  static const std::vector<Option> table = [] {
    std::vector<Option> all;
    for (const auto& part : {imageOptions(), sceneFileOptions(), executionOptions(), outputOptions(), filmOptions(),
                             comparisonOptions(), verificationOptions(), explanationOptions(), benchmarkOptions(),
                             tuningOptions(), generationOptions(), generalOptions()}) {
      all.insert(all.end(), part.begin(), part.end());
    }
    return all;
  }();
  return table;
}

std::string commandLineOf(const Arguments& arguments, OptionGroup group, bool onlyChanged) {
  std::string line;
  for (const Option& option : optionTable()) {
    if (option.group != group) continue;
    for (const std::string& value : option.show(arguments)) {
      if (value.empty() || (onlyChanged && value == option.defaultText)) continue;
      if (!line.empty()) line += ' ';
      line += option.name();
      if (!option.isFlag()) line.append(1, ' ').append(shellQuoted(value));
    }
  }
  return line;
}

std::string shellQuoted(const std::string& word) {
  constexpr const char* kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._-+/=:,@%";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char character : word) {
    if (character == '\'') {
      quoted += "'\\''";
    } else {
      quoted += character;
    }
  }
  return quoted + "'";
}

}  // namespace candela::cli
