// Options that decide the image, options of the scene file, and those of sequences.
#include "host/app/cli/option_groups.h"
#include "host/app/cli/option_kinds.h"

namespace candela::cli {
namespace {

constexpr std::uint32_t kMaxSegments = 1u << 20;
constexpr std::uint32_t kMaxFrame = 1u << 24;
constexpr float kMinReach = 1e-30f;
constexpr float kMaxReach = 1e30f;

const std::vector<std::pair<std::string, bool>> kOnOff{{"on", true}, {"off", false}};

std::string defaultDepths() {
  return fmt::format("the scene's, else {}; whitted: {}", defaultMaxDepth(render::Integrator::path),
                     defaultMaxDepth(render::Integrator::whitted));
}

Notation<std::uint32_t> seedNumber() { return wholeNumber(0, std::numeric_limits<std::uint32_t>::max()); }

/// An option for the seed that also accepts the word `frame`.
Option seedOfFrames(Option option) {
  constexpr const char* kFrame = "frame";
  option.expected += fmt::format(", or {}", kFrame);
  option.apply = [number = option.apply](Arguments& arguments, const std::string& word) {
    partOf<SequenceArguments>(arguments).seedIsFrame = word == kFrame;
    return word == kFrame || number(arguments, word);
  };
  option.show = [number = option.show](const Arguments& arguments) {
    return partOf<SequenceArguments>(arguments).seedIsFrame ? std::vector<std::string>{kFrame} : number(arguments);
  };
  return option;
}

}  // namespace

// NOLINTBEGIN: each option is one row of any length.
// clang-format off
std::vector<Option> imageOptions() {
  constexpr OptionGroup kGroup = OptionGroup::image;
  const std::string defaultSamples = fmt::format("the scene's `spp`, else {}", render::ImageSettings{}.sampleCount);
  return {
    valued<TracingArguments, kTracingButVerify & ~kView>({"--spp", kGroup, "samples per pixel; 0: one ray through the centre of each pixel, without antialiasing"},
           orAbsent(wholeNumber(0, render::kMaxSampleCount), defaultSamples), [](auto& a) -> auto& { return a.request.sampleCount; }),
    valued<TracingArguments, commandsWith<TracingArguments> & ~kRender>({"--seed", kGroup, "seed of the random numbers"}, seedNumber(), [](auto& a) -> auto& { return a.request.image.seed; }),
    seedOfFrames(valued<RenderArguments>({"--seed", kGroup, "seed of the random numbers; `frame`: each frame of a sequence has its number as its seed"}, seedNumber(), [](auto& a) -> auto& { return a.request.image.seed; })),
    valued<TracingArguments>({"--size", kGroup, "image size in pixels"},
           orAbsent(extent("WxH", image::kMaxImageSide), "the scene's"), [](auto& a) -> auto& { return a.request.size; }),
    valued<TracingArguments>({"--max-depth", kGroup, "maximum number of rays in a path, counting the camera ray"},
           orAbsent(wholeNumber(1, kMaxSegments), defaultDepths()), [](auto& a) -> auto& { return a.request.maxDepth; }),
    valued<TracingArguments>({"--rr-start", kGroup, "number of path vertices before Russian roulette starts"},
           wholeNumber(0, kMaxSegments), [](auto& a) -> auto& { return a.request.image.rouletteStart; }),
    valued<TracingArguments>({"--integrator", kGroup, "`path`: path tracing; `whitted`: Whitted ray tracing; the others: views of what camera rays hit"},
           named<render::Integrator>(), [](auto& a) -> auto& { return a.request.image.integrator; }),
    valued<TracingArguments>({"--ao-distance", kGroup, "maximum distance of occluders for `ao`; `auto`: a quarter of the distance from eye to target"},
           orAbsent(realNumber<float>("D", kMinReach, kMaxReach), "auto"), [](auto& a) -> auto& { return a.request.image.aoDistance; }),
    valued<TracingArguments>({"--nee", kGroup, "next-event estimation: sample the lights at every path vertex"},
           choice(kOnOff), [](auto& a) -> auto& { return a.request.image.nextEventEstimation; }),
    valued<TracingArguments>({"--lights", kGroup, "how light sampling chooses a light: by its `power`, or by a `tree`, which prefers near ones that face the point; `auto`: by a tree if there are many"},
           orAbsent(named<render::LightSelection>(), "auto"), [](auto& a) -> auto& { return a.request.lights; }),
    valued<TracingArguments>({"--sampler", kGroup, "how random numbers are generated"},
           named<render::SamplerKind>(), [](auto& a) -> auto& { return a.request.image.sampler; }),
    valued<TracingArguments>({"--filter", kGroup, "pixel filter; `gaussian`: with a standard deviation of 0.5 pixels, or of S; it ends at 4 standard deviations"},
           orAbsent(pixelFilter(scene::kMinDeviation, scene::kMaxDeviation), "the scene's, else box"), [](auto& a) -> auto& { return a.request.filter; }),
    valued<TracingArguments>({"--lens", kGroup, "shape of the lens, if the scene's camera has an aperture"},
           named<render::LensKind>(), [](auto& a) -> auto& { return a.request.image.lens; }),
    valued<TracingArguments>({"--pixel-origin", kGroup, "points through which camera rays pass without jitter: the centres of the pixels, or the corners of a grid of (W-1)x(H-1) cells"},
           named<render::PixelOrigin>(), [](auto& a) -> auto& { return a.request.image.pixelOrigin; }),
    valued<TracingArguments>({"--light-size", kGroup, "for `whitted`: side of the square area lights that replace point lights; 0: point lights"},
           realNumber<float>("S", 0, 1e30f), [](auto& a) -> auto& { return a.request.image.lightSize; }),
    valued<TracingArguments, kTracingButVerify>({"--clamp-indirect", kGroup, "limit of each contribution of light that was scattered twice or more, to suppress fireflies; the image becomes too dark, and its files say so; `off`: unbiased"},
           orAbsent(realNumber<float>("V", 1e-6f, 1e6f), "off"), [](auto& a) -> auto& { return a.request.image.indirectLimit; }),
    valued<TracingArguments, kTracingButVerify>({"--background", kGroup, "what camera rays see where they hit nothing; `env`: the environment, sky or background colour that lights the scene; `colour`: the scene's background colour; `none`: nothing, and PNG and EXR files have alpha; the light on surfaces stays the same"},
           named<render::Backdrop>(), [](auto& a) -> auto& { return a.request.image.backdrop; }),
    valued<TracingArguments>({"--film-scale", kGroup, "scale of the film, a power of two: samples up to 2^(20+N) are recorded in units of 2^(N-40), brighter ones are clamped; `auto`: 0, and more if the scene has strong lights"},
           orAbsent(wholeNumber(0, image::kMaxFilmScale), "auto"), [](auto& a) -> auto& { return a.request.filmScale; }),
    flag<TracingArguments, kLayered>({"--aov-through-specular", kGroup, "let layers of surfaces show the first hit that is neither a perfect mirror nor glass; layers of light stay the same"},
         [](auto& a) -> auto& { return a.request.image.layersThroughSpecular; }),
    valued<RenderArguments>({"--noise-threshold", kGroup, "sample adaptively: stop sampling a pixel when its estimated relative error is at most T, for example 0.1; --spp is the maximum number of samples; `off`: --spp samples everywhere"},
           orAbsent(fraction("T", 1e-6, 1e6), "off"), [](auto& a) -> auto& { return a.film.noiseThreshold; }),
    flag<TracingArguments>({"--one-sided", kGroup, "let rays pass through the backs of opaque polygons and planes, as in NFF"},
         [](auto& a) -> auto& { return a.request.image.oneSided; }),
  };
}

std::vector<Option> sceneFileOptions() {
  constexpr OptionGroup kGroup = OptionGroup::sceneFile;
  return {
    flag<SceneArguments>({"--lenient", kGroup, "read faulty files as far as possible, with warnings: skip unknown statements and complete short ones; for glTF and OBJ, leave out images that cannot be read; for Mitsuba, replace what is not rendered; replace pixels of an environment that are not finite"},
         [](auto& a) -> auto& { return a.loadOptions.lenient; }),
    paths<SceneArguments>({"--allow-path", kGroup, "folder, besides the scene's own, from which a scene may read files; repeatable"}, "DIR",
          [](auto& a) -> auto& { return a.loadOptions.allowedPaths; }),
    list<SceneArguments>({"-D,--define", kGroup, "for Mitsuba: value of a parameter, instead of the scene's <default>; repeatable"}, "NAME=VALUE", "a definition",
         [](auto& a) -> auto& { return a.loadOptions.definitions; }),
    valued<SceneArguments, kSurrounding>({"--env", kGroup, "environment that replaces the background: an equirectangular image (.hdr, .exr, .pfm, .png, .jpg or .webp), `white`, or the daylight `sun:ELEVATION,AZIMUTH,TURBIDITY`"},
           text("FILE", "an environment", "none"), [](auto& a) -> auto& { return a.loadOptions.environment.source; }),
    valued<SceneArguments, kSurrounding>({"--env-rotate", kGroup, "rotation of the environment about the axis that points up, counterclockwise seen from above"},
           realNumber<double>("DEG", -360, 360), [](auto& a) -> auto& { return a.loadOptions.environment.rotation; }),
    valued<SceneArguments, kSurrounding>({"--env-scale", kGroup, "factor of the environment's radiance"},
           realNumber<double>("S", 0, 1e30), [](auto& a) -> auto& { return a.loadOptions.environment.scale; }),
    valued<SceneArguments>({"--camera", kGroup, "for glTF and Mitsuba: name or index of the camera; `none`: a view that frames the model"},
           orAbsent(text("NAME|N", "a camera"), "the first, else none"), [](auto& a) -> auto& { return a.loadOptions.camera; }),
    valued<SceneArguments>({"--time", kGroup, "for glTF: time in the animation, in seconds"},
           orAbsent(realNumber<double>("SECONDS", 0, 1e9), "the pose at rest"), [](auto& a) -> auto& { return a.loadOptions.time; }),
    valued<SceneArguments>({"--animation", kGroup, "for glTF: name or index of the animation that --time applies to"},
           orAbsent(text("NAME|N", "an animation"), "the first"), [](auto& a) -> auto& { return a.loadOptions.animation; }),
    valued<SceneArguments>({"--orbit", kGroup, "angle by which the camera is turned about its target, about the axis that points up, counterclockwise seen from above"},
           realNumber<double>("DEG", -360, 360), [](auto& a) -> auto& { return a.loadOptions.orbit; }),
  };
}

std::vector<Option> sequenceOptions() {
  constexpr OptionGroup kGroup = OptionGroup::sequence;
  return {
    valued<RenderArguments>({"--frames", kGroup, "render the frames A to B - 1 of an animation, each at its number divided by --fps; in the names of files, the number replaces the last run of #: frame.####.png"},
           orAbsent(range<job::FrameRange>(kMaxFrame), "none"), [](auto& a) -> auto& { return a.frames; }),
    valued<RenderArguments>({"--fps", kGroup, "frames per second"},
           realNumber<double>("F", 1e-3, 1e6), [](auto& a) -> auto& { return a.framesPerSecond; }),
    valued<RenderArguments>({"--turntable", kGroup, "render N frames in which the camera turns once about its target: see --orbit; with --fps, the animation plays as well"},
           orAbsent(wholeNumber(1, kMaxFrame), "none"), [](auto& a) -> auto& { return a.turntable; }),
  };
}
// clang-format on
// NOLINTEND

}  // namespace candela::cli
