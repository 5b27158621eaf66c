// `candela report` and the kit's script as a newcomer uses them, without a device.
#include <catch2/catch.hpp>
#include <csignal>
#include <filesystem>
#include <sstream>

#include "tests/app/cli/run_program.h"

namespace candela {
namespace {

constexpr const char*
    kResults = R"({"schema": "candela-kit/2", "version": "0.2.0", "system": "Linux", "processor": "A processor",
  "quick": true, "steps": [], "conformance": {"device": "A GPU", "driver": "driver 1", "counts": {"Pass": 1}, "cases": []},
  "verify": [], "bench": [], "rays": [], "tune": null})";

const std::string kScript = std::string(CANDELA_SOURCE_DIR) + "/cmake/kit/run.sh";

// A substitute for the program with two devices. It writes its arguments to the file `calls`, and its tuning fails.
constexpr const char* kProgram = R"(#!/bin/sh
echo "$*" >> "${0%/*}/calls"
gpu='{
"index": 0,
"name": "A GPU",
"type": "discrete GPU",
"default": true
}'
software='{
"index": 1,
"name": "SwiftShader Device",
"type": "CPU",
"default": false
}'
for last; do :; done
case $* in
"devices --json "*) echo "[$gpu,$software]" > "$last" ;;
"devices --device "[0A]*) echo "[$gpu]" > "$last" ;;
"devices --device "[1S]*) echo "[$software]" > "$last" ;;
devices*) printf 'candela: no such device; available devices:\ncandela:   0: A GPU\n' >&2; exit 4 ;;
report*) touch "$4" "$6" ;;
tune*) printf 'a driver says something\ncandela: the cause\ncandela: and the remedy\n' >&2; exit 6 ;;
esac
)";

// The script beside a substitute for the program.
class Kit {
 public:
  explicit Kit(const std::string& program) {
    std::filesystem::copy_file(kScript, folder_.path("run.sh"));
    std::filesystem::permissions(folder_.write("candela", program), std::filesystem::perms::owner_all);
    std::filesystem::create_directory(folder_.path("scenes"));
    folder_.write("scenes/cornell.p3f", "");
    std::filesystem::create_directory(folder_.path("tmp"));
  }

  std::string path(const std::string& name) const { return folder_.path(name); }

  ProgramResult run(const std::vector<std::string>& options, Surroundings surroundings = {}) const {
    std::vector<std::string> words{path("run.sh"), "-o", path("out")};
    words.insert(words.end(), options.begin(), options.end());
    surroundings.environment.push_back("TMPDIR=" + path("tmp"));
    return runProgram("/bin/sh", words, surroundings);
  }

  // The arguments of the substitute's call for a step.
  std::string call(const std::string& step) const {
    std::istringstream calls(readText(path("calls")));
    std::string line;
    while (std::getline(calls, line) && !line.starts_with(step)) {
    }
    return line;
  }

 private:
  TemporaryFolder folder_;
};

}  // namespace

TEST_CASE("report prints a table, and writes Markdown and a chart") {
  const TemporaryFolder folder;
  const std::string results = folder.write("results.json", kResults);
  const ProgramResult text = runCandela({"report", results, results});
  CHECK(text.exitCode == 0);
  CHECK(contains(text.out, "A GPU"));
  CHECK(runCandela({"report", results, "--markdown", folder.path("page.md"), "--svg", folder.path("chart.svg")})
            .exitCode == 0);
  CHECK(contains(readText(folder.path("page.md")), "| A GPU | driver 1 | 1 Pass | not run |"));
  CHECK(contains(readText(folder.path("chart.svg")), "<svg"));
}

TEST_CASE("report refuses what it cannot read or write") {
  const TemporaryFolder folder;
  const std::string results = folder.write("results.json", kResults);
  const std::string scene = folder.write("scene.p3f", smallScene());
  struct Refusal {
    std::vector<std::string> words;
    int exitCode;
    const char* message;
  };
  for (const Refusal& refusal :
       std::vector<Refusal>{{{}, 1, "no results file given"},
                            {{"/nonexistent.json"}, 2, "/nonexistent.json"},
                            {{scene}, 2, "scene.p3f"},
                            {{results, "--svg", "/nonexistent/chart.svg"}, 2, "/nonexistent"}}) {
    std::vector<std::string> words{"report"};
    words.insert(words.end(), refusal.words.begin(), refusal.words.end());
    const ProgramResult result = runCandela(words);
    INFO(result.err);
    CHECK(result.exitCode == refusal.exitCode);
    CHECK(contains(result.err, refusal.message));
  }
}

TEST_CASE("the kit's script ends at once when it is interrupted in a step, with the program and without remains") {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const Kit kit(
        "#!/bin/sh\nfor last; do :; done\ncase $1 in\ndevices) echo '{}' > \"$last\" ;;\n"
        "*) echo $$ > \"${0%/*}/step\"; sleep 120 & trap 'kill $!; exit 7' TERM; wait ;;\nesac\n");
    const auto start = std::chrono::steady_clock::now();
    const ProgramResult result = kit.run({"--device", "0"},
                                         {.interruptAfter = std::chrono::seconds(2), .signal = signal});
    CAPTURE(signal);
    CHECK(result.exitCode == 7);
    CHECK(contains(result.err, "run.sh: interrupted, and no results are written"));
    CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(30));
    CHECK(::kill(std::stoi(readText(kit.path("step"))), 0) != 0);
    CHECK(std::filesystem::is_empty(kit.path("tmp")));
    CHECK(std::filesystem::is_empty(kit.path("out")));
  }
}

TEST_CASE(
    "all steps of the kit's script use one device, whose kind decides the images and the cases that are skipped") {
  const Kit gpu(kProgram);
  CHECK(gpu.run({}).exitCode == 0);
  CHECK(contains(gpu.call("conformance"), "conformance --device 0 "));
  CHECK(contains(gpu.call("verify"), " --size 256x256 "));
  CHECK(contains(gpu.call("bench "), " --size 1024x1024 "));

  const Kit software(kProgram);
  const ProgramResult result = software.run({"--device", "Swift"});
  CHECK(result.exitCode == 0);
  CHECK(contains(software.call("conformance"), "/baselines/swiftshader-skips.txt --device Swift "));
  CHECK(contains(software.call("verify"), " --size 64x64 "));
  CHECK(contains(software.call("tune"), " --device Swift "));
  CHECK(contains(result.out, "tune ... failed with exit code 6: the cause\n"));
}

TEST_CASE("the kit's script refuses a device that does not exist before any step") {
  const Kit kit(kProgram);
  const ProgramResult result = kit.run({"--device", "NOPE"});
  CHECK(result.exitCode == 4);
  CHECK(result.out.empty());
  CHECK(result.err == "candela: no such device; available devices:\ncandela:   0: A GPU\n");
  CHECK(std::filesystem::is_empty(kit.path("tmp")));
}

TEST_CASE("the kit's script explains itself and refuses wrong options") {
  CHECK(contains(runProgram("/bin/sh", {kScript, "--help"}).out, "Usage: ./run.sh"));
  for (const std::vector<std::string>& words : {std::vector<std::string>{"--fast"}, {"--device"}, {"-o"}}) {
    std::vector<std::string> all{kScript};
    all.insert(all.end(), words.begin(), words.end());
    const ProgramResult result = runProgram("/bin/sh", all);
    CHECK(result.exitCode == 1);
    CHECK(contains(result.err, "run.sh: " + words.front()));
  }
}

}  // namespace candela
