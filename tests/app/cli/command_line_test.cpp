// Words of a command line become Arguments or a helpful UsageError.
#include "host/app/cli/command_line.h"

#include <catch2/catch.hpp>

#include "host/base/errors.h"

namespace candela::cli {
namespace {

// Returns the arguments of a command, or a part of them.
template <class Part = RenderArguments>
Part parse(const std::vector<std::string>& words) {
  const Arguments arguments = parseCommandLine(words);
  return partOf<Part>(arguments);
}

std::string messageFor(const std::vector<std::string>& words) {
  try {
    parseCommandLine(words);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace

TEST_CASE("the command render may be omitted") {
  for (const auto& words : {std::vector<std::string>{"a.p3f", "-o", "a.png"},
                            {"render", "a.p3f", "-o", "a.png"},
                            {"-o", "a.png", "a.p3f"},
                            {"render", "-oa.png", "a.p3f"},
                            {"--output=a.png", "a.p3f"}}) {
    const RenderArguments arguments = parse(words);
    CHECK(arguments.files == std::vector<std::string>{"a.p3f"});
    CHECK(arguments.outputs == std::vector<std::filesystem::path>{"a.png"});
  }
}

TEST_CASE("defaults of options are those of the settings") {
  const RenderArguments arguments = parse({"a.p3f", "-o", "a.png"});
  CHECK_FALSE(arguments.request.sampleCount);
  CHECK_FALSE(arguments.request.size);
  CHECK_FALSE(arguments.request.accel);
  CHECK_FALSE(arguments.request.maxDepth);
  CHECK(arguments.device.empty());
  CHECK(arguments.request.image.seed == 0);
  CHECK(arguments.request.image.rouletteStart == 4);
  CHECK(arguments.request.image.nextEventEstimation);
  CHECK(arguments.request.image.sampler == render::SamplerKind::sobol);
  CHECK(arguments.verbosity() == Verbosity::normal);
}

TEST_CASE("repeated outputs add up, and of other repeated options the last one counts") {
  const RenderArguments arguments = parse({"a.p3f", "-o", "a.png", "--seed", "1", "-o", "b.exr", "--seed", "2"});
  CHECK(arguments.outputs == std::vector<std::filesystem::path>{"a.png", "b.exr"});
  CHECK(arguments.request.image.seed == 2);
}

TEST_CASE("a negative number is a value, not an option") {
  CHECK(parse({"a.p3f", "-o", "a.png", "--exposure", "-1.5"}).exposure == -1.5f);
}

TEST_CASE("a file whose name begins with a dash may follow two dashes") {
  CHECK(parse({"-o", "a.png", "--", "-a.p3f"}).files == std::vector<std::string>{"-a.p3f"});
}

TEST_CASE("a wrong command line names the expected value and the help") {
  CHECK(messageFor({}) == "no scene given\nsee candela --help");
  CHECK(messageFor({"a.p3f", "--sp", "4"}) == "unknown option --sp; did you mean --spp?\nsee candela render --help");
  CHECK(messageFor({"a.p3f", "--size", "70000x1"}) ==
        "--size: expected WxH with both from 1 to 65535, got \"70000x1\"\nsee candela render --help");
  CHECK(messageFor({"a.p3f", "--nee", "maybe"}) ==
        "--nee: expected on or off, got \"maybe\"\nsee candela render --help");
  CHECK(messageFor({"a.p3f", "-o", "a.png", "--spp"}) == "--spp needs a value\nsee candela render --help");
  CHECK(messageFor({"a.p3f", "--one-sided=no"}) ==
        "--one-sided: expected no value, got \"no\"\nsee candela render --help");
  CHECK(messageFor({"rendr", "a.p3f"}) == "unknown command rendr; did you mean render?\nsee candela --help");
  CHECK(messageFor({"check"}) == "no scene given\nsee candela check --help");
  CHECK(messageFor({"a.p3f", "b.p3f", "-o", "a.png"}) ==
        "too many arguments: b.p3f is unexpected\nsee candela render --help");
  CHECK(messageFor({"devices", "--spp", "4"}) ==
        "--spp is not an option of candela devices\nsee candela devices --help");
  CHECK(messageFor({"a.p3f"}) ==
        "no output given: write the image with -o FILE or the film with --checkpoint FILE, or only measure with "
        "--stats or --json FILE\nsee candela "
        "render --help");
  CHECK(messageFor({"a.p3f", "--stats", "--json", "-"}) ==
        "--stats and --json - both write to stdout\nsee candela render --help");
  CHECK(messageFor({"conformance", "--csv", "-", "--junit", "-"}) ==
        "--csv - and --junit - both write to stdout\nsee candela conformance --help");
}

TEST_CASE("a wrong value is named with the words that are allowed, and with a suggestion") {
  const auto message = [](const std::string& option, const std::string& value) {
    const std::string text = messageFor({"a.p3f", "-o", "a.png", option, value});
    return text.substr(0, text.find('\n'));
  };
  CHECK(message("--clamp-indirect", "0") ==
        "--clamp-indirect: expected a number from 1e-06 to 1000000, or off, got \"0\"");
  CHECK(message("--exposure", "lots") == "--exposure: expected a number from -64 to 64, or auto, got \"lots\"");
  CHECK(message("--tile", "foo") == "--tile: expected WxH with both from 1 to 65535, or auto, got \"foo\"");
  CHECK(message("--background", "color") ==
        "--background: expected env, colour or none, got \"color\"; did you mean colour?");
  CHECK(message("--tone", "agx") == "unknown option --tone; did you mean --tonemap?");
  const std::string layers = message("--aov", "normal,zdepth");
  CHECK(layers.substr(layers.find(", got ")) == ", got \"zdepth\"; did you mean depth?");
  CHECK(parse({"a.p3f", "-o", "a.png", "--noise-threshold", "20%"}).film.noiseThreshold == 0.2);
  CHECK(parse({"a.p3f", "-o", "a.png", "--size", "48X32"}).request.size == render::Extent{48, 32});
}

TEST_CASE("a dash as scene is stdin") {
  CHECK(parse({"-", "-o", "a.png"}).files == std::vector<std::string>{"/dev/stdin"});
  CHECK(parse<CheckArguments>({"check", "a.p3f", "-"}).files == std::vector<std::string>{"a.p3f", "/dev/stdin"});
  CHECK(messageFor({"a.glb", "-o", "a.png", "--animation", "Walk"}) ==
        "--animation has no effect without --time\nsee candela render --help");
}

TEST_CASE("a short option takes its value with or without an equals sign") {
  CHECK(parse({"a.p3f", "-o=a.png"}).outputs == std::vector<std::filesystem::path>{"a.png"});
  CHECK(parse({"a.p3f", "-oa.png", "-t=4"}).request.execution.threads == 4);
  CHECK(parse({"-o", "a.png", "--", "-o=a.p3f"}).files == std::vector<std::string>{"-o=a.p3f"});
}

TEST_CASE("help of a command can be requested in any usual way") {
  for (const auto& words :
       {std::vector<std::string>{"help", "bench"}, {"--help", "bench"}, {"-h", "bench"}, {"bench", "--help"}}) {
    const BenchArguments arguments = parse<BenchArguments>(words);
    CHECK(arguments.help);
    CHECK(arguments.commandNamed);
  }
  CHECK(parse({"help"}).help);
  CHECK_FALSE(parse({"help"}).commandNamed);
  CHECK(messageFor({"help", "bnech"}) == "unknown command bnech; did you mean bench?\nsee candela --help");
  CHECK(messageFor({"help", "zzzzz"}) == "unknown command zzzzz\nsee candela --help");
}

TEST_CASE("names of other formats are refused with a better name") {
  CHECK(messageFor({"merge", "a.exr", "-o", "b/picture.png"}) ==
        "b/picture.png: a film is an OpenEXR file; name it b/picture.exr\nsee candela merge --help");
  CHECK(messageFor({"a.p3f", "--checkpoint", "film.PNG"}) ==
        "film.PNG: a film is an OpenEXR file; name it film.exr\nsee candela render --help");
  CHECK(messageFor({"compare", "a.exr", "b.exr", "--report", "page.pdf"}) ==
        "page.pdf: the report is an HTML page; name it page.html\nsee candela compare --help");
  CHECK(parse<MergeArguments>({"merge", "a.exr", "-o", "film.v2"}).output == "film.v2");
  CHECK(parse<CompareArguments>({"compare", "a.exr", "b.exr", "--report", "page.htm"}).report == "page.htm");
}

TEST_CASE("generate has its own --size and -o") {
  const auto arguments = parse<GenerateArguments>({"generate", "balls", "--size", "3", "-o", "balls.nff"});
  CHECK(arguments.files == std::vector<std::string>{"balls"});
  CHECK(arguments.size == 3u);
  CHECK(arguments.generatedFile == "balls.nff");
  CHECK(messageFor({"generate", "balls", "--size", "3x3"}) ==
        "--size: expected a whole number from 0 to 4294967295, got \"3x3\"\nsee candela generate --help");
  CHECK(messageFor({"a.p3f", "-o", "a.png", "--size", "3"}) ==
        "--size: expected WxH with both from 1 to 65535, got \"3\"\nsee candela render --help");
  CHECK(messageFor({"generate"}) == "no kind given\nsee candela generate --help");
  CHECK(messageFor({"generate", "balls", "--spp", "4"}) ==
        "--spp is not an option of candela generate\nsee candela generate --help");
}

TEST_CASE("the maximum depth of a tree of rays is lower than that of a path") {
  CHECK(parse({"a.p3f", "-o", "a.png", "--max-depth", "5000"}).request.maxDepth == 5000);
  CHECK(parse({"a.p3f", "-o", "a.png", "--integrator", "whitted", "--max-depth", "20"}).request.maxDepth == 20);
  CHECK(messageFor({"a.p3f", "-o", "a.png", "--max-depth", "21", "--integrator", "whitted"}) ==
        "--max-depth 21: the maximum of Whitted ray tracing is 20\nsee candela render --help");
}

TEST_CASE("options of one comparison are refused for the other") {
  CHECK(messageFor({"compare", "a.exr", "b.exr", "--spp", "4"}) ==
        "--spp is for comparing one scene, not two images\nsee candela compare --help");
  CHECK(messageFor({"compare", "a.p3f", "--tolerance", "1"}) ==
        "--tolerance is for comparing two images, not one scene\nsee candela compare --help");
}

TEST_CASE("the options --help and --version need no other arguments") {
  CHECK(parse({"--help"}).help);
  CHECK_FALSE(parse({"-h"}).commandNamed);
  CHECK(parse<CompareArguments>({"compare", "-h"}).commandNamed);
  CHECK(parse({"--version"}).version);
}

}  // namespace candela::cli
