// The JSON documents of all commands follow docs/json.md.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <set>

#include "host/app/cli/commands.h"
#include "host/app/cli/option_table.h"
#include "tests/app/cli/json_rules.h"
#include "tests/app/cli/run_program.h"

namespace candela {
namespace {

using nlohmann::ordered_json;

/// A command line that writes a document, without its option --json.
struct Document {
  std::string schema;
  std::vector<std::string> words;
  bool takesDevice = true;
  int exitCode = 0;
};

/// Scenes, images, films and a report of a benchmark, for commands that read them.
class Inputs {
 public:
  Inputs() {
    folder_.write("a.p3f", smallScene());
    folder_.write("broken.p3f", "s 1 2 3\n");
    for (const char* seed : {"1", "2"}) {
      const std::string name = std::string("a") + seed;
      render({"--seed", seed, "-o", path(name + ".exr")});
    }
    render({"--samples", "0:2", "--checkpoint", path("first.exr")});
    render({"--samples", "2:4", "--checkpoint", path("second.exr")});
    run({"bench", path("a.p3f"), "--device", "cpu", "--size", "8x8", "--spp", "1", "--repeat", "1", "--json",
         path("bench.json")});
    folder_.write("runs.json", R"({"schema": "candela-error-runs/1", "scene": "a", "tracers": [{"tracer": "t",
      "samplesPerPixel": 4, "reference": ["a1.exr", "a1.exr"],
      "pictures": [{"file": "a2.exr", "seconds": 1}, {"file": "a2.exr", "seconds": 1}]}]})");
    folder_.write("kernels.json", R"({"schema": "candela-kernels/1", "device": "d", "driver": "v", "driverName": "n",
      "rows": [{"scene": "a", "sceneHash": "1", "kernel": "megakernel", "workgroup": "8x8", "cycles": 1}]})");
  }

  std::string path(const std::string& name) const { return folder_.path(name); }

 private:
  void render(std::vector<std::string> options) const {
    options.insert(options.begin(), {"render", path("a.p3f"), "--device", "cpu", "--spp", "4"});
    run(options);
  }
  static void run(const std::vector<std::string>& words) {
    const ProgramResult result = runCandela(words);
    INFO(result.err);
    REQUIRE(result.exitCode == 0);
  }

  TemporaryFolder folder_;
};

std::vector<Document> documentsOf(const Inputs& in) {
  const std::string scene = in.path("a.p3f");
  const std::vector<std::string> quick{"--size", "8x8", "--spp", "2"};
  const auto with = [&](std::vector<std::string> words, const std::vector<std::string>& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
  };
  const std::vector<std::string> once{"--size", "8x8", "--spp", "1", "--repeat", "1"};
  return {
      {"candela-render/1", with({"render", scene}, quick)},
      {"candela-render/1", with({"render", scene, "--device", "cpu"}, quick), false},
      {"candela-render/1", with({"render", scene, "--integrator", "whitted"}, quick)},
      {"candela-render/1", {"render", scene, "--noise-threshold", "20%", "--size", "8x8", "--spp", "66"}},
      {"candela-devices/1", {"devices"}, false},
      {"candela-doctor/2", {"doctor"}},
      {"candela-check/1", {"check", scene}, false},
      {"candela-check/1", {"check", in.path("broken.p3f")}, false, 2},
      {"candela-compare-images/1", {"compare", in.path("a1.exr"), in.path("a2.exr")}, false, 8},
      {"candela-compare-images/1", {"compare", in.path("a1.exr"), in.path("a2.exr"), "--allow-undecided"}, false},
      {"candela-compare-images/1", {"compare", in.path("a1.exr"), in.path("a2.exr"), "--tolerance", "0"}, false, 3},
      {"candela-compare-renders/1", {"compare", in.path("a1.exr"), "--with", in.path("a2.exr")}, false, 8},
      {"candela-compare-tracers/1", with({"compare", scene}, quick)},
      {"candela-verify/3", {"verify", scene, "--size", "8x8", "--bias", "20%", "--explain"}},
      {"candela-verify/3", {"verify", scene, "--size", "8x8", "--bias", "0.00001%"}, true, 8},
      {"candela-explain/2", {"explain", scene, "--size", "8x8", "--pixel", "4,3"}},
      {"candela-explain/2", {"explain", scene, "--size", "8x8"}},
      {"candela-conformance/2", {"conformance", "--cases", "leaf.integer.add_carry"}},
      {"candela-bench/2", with({"bench", scene}, once)},
      {"candela-bench/2", with({"bench", scene, "--error", "2", "--repeat", "2"}, quick)},
      {"candela-bench-error/1", {"bench", "error", in.path("runs.json")}, false},
      {"candela-bench/2", with({"bench", "accel", scene}, once)},
      {"candela-bench/2", {"bench", "rays", scene, "--size", "8x8", "--repeat", "1"}},
      {"candela-bench-comparison/2", {"bench", "compare", in.path("bench.json"), in.path("bench.json")}, false},
      {"candela-kernels/1", {"kernels", scene}},
      {"candela-kernels-comparison/1", {"kernels", "compare", in.path("kernels.json"), in.path("kernels.json")}, false},
      {"candela-film/1", {"film", in.path("first.exr")}, false},
      {"candela-film/1", {"merge", in.path("first.exr"), in.path("second.exr"), "-o", in.path("all.exr")}, false},
  };
}

std::vector<std::string> wordsOf(const Document& document) {
  std::vector<std::string> words = document.words;
  const char* const device = std::getenv("CANDELA_TEST_DEVICE");
  if (document.takesDevice && device != nullptr) words.insert(words.end(), {"--device", device});
  words.insert(words.end(), {"--json", "-"});
  return words;
}

std::set<std::string> commandsWithJson() {
  std::set<std::string> names;
  for (const cli::Option& option : cli::optionTable()) {
    if (option.name() != "--json") continue;
    for (const cli::CommandInfo& command : cli::commandTable()) {
      if (option.isFor(command.command)) names.insert(command.name);
    }
  }
  return names;
}

}  // namespace

TEST_CASE("the JSON documents of all commands follow the rules", "[swiftshader-slow]") {
  const Inputs inputs;
  std::set<std::string> commands{"view", "tune"};  // tests/app/view, tune_program_test.cpp
  for (const Document& document : documentsOf(inputs)) {
    commands.insert(document.words.front());
    const ProgramResult result = runCandela(wordsOf(document));
    CAPTURE(document.words, result.err);
    REQUIRE(result.exitCode == document.exitCode);
    CHECK(violationsOf(ordered_json::parse(result.out), document.schema) == std::vector<std::string>{});
  }
  CHECK(commands == commandsWithJson());
}

}  // namespace candela
