// `candela report` and the kit's script as a newcomer uses them, without a device.
#include <catch2/catch.hpp>
#include <csignal>
#include <filesystem>

#include "tests/cli/run_program.h"

namespace candela {
namespace {

constexpr const char*
    kResults = R"({"schema": "candela-kit/2", "version": "0.2.0", "system": "Linux", "processor": "A processor",
  "quick": true, "steps": [], "conformance": {"device": "A GPU", "driver": "driver 1", "counts": {"Pass": 1}, "cases": []},
  "verify": [], "bench": [], "rays": [], "tune": null})";

const std::string kScript = std::string(CANDELA_SOURCE_DIR) + "/cmake/kit/run.sh";

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
    const TemporaryFolder folder;
    std::filesystem::copy_file(kScript, folder.path("run.sh"));
    const std::string program = folder.write(
        "candela",
        "#!/bin/sh\ncase $1 in\ndevices) echo '{}' > \"$3\" ;;\n"
        "*) echo $$ > \"${0%/*}/step\"; sleep 120 & trap 'kill $!; exit 7' TERM; wait ;;\nesac\n");
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    std::filesystem::create_directory(folder.path("tmp"));
    const auto start = std::chrono::steady_clock::now();
    const ProgramResult result = runProgram(
        "/bin/sh", {folder.path("run.sh"), "-o", folder.path("out")},
        {.environment = {"TMPDIR=" + folder.path("tmp")}, .interruptAfter = std::chrono::seconds(2), .signal = signal});
    CAPTURE(signal);
    CHECK(result.exitCode == 7);
    CHECK(contains(result.err, "run.sh: interrupted, and no results are written"));
    CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(30));
    CHECK(::kill(std::stoi(readText(folder.path("step"))), 0) != 0);
    CHECK(std::filesystem::is_empty(folder.path("tmp")));
    CHECK(std::filesystem::is_empty(folder.path("out")));
  }
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
