// Runs all commands of docs/ci.md, in their order, in a repository as the page describes it.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <iterator>
#include <optional>
#include <regex>
#include <set>
#include <sstream>

#include "host/app/cli/help.h"
#include "host/app/cli/option_table.h"
#include "tests/app/cli/marked_page.h"
#include "tests/app/cli/run_program.h"

namespace candela {
namespace {

namespace fs = std::filesystem;

MarkedPage readPage() { return readMarkedPage(readText(CANDELA_SOURCE_DIR "/docs/ci.md")); }

const MarkedBlock& theBlock(const MarkedPage& page, const std::string& mark) {
  const auto found = std::ranges::find(page.blocks, mark, &MarkedBlock::mark);
  REQUIRE(found != page.blocks.end());
  return *found;
}

std::set<std::string> wordsOf(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

// Returns the packages that an apt-get command installs; nothing for other apt-get commands.
std::set<std::string> installedBy(const std::string& commands) {
  std::set<std::string> words = wordsOf(commands);
  if (!words.contains("install")) return {};
  for (const char* word : {"apt-get", "update", "install", "-y", "--no-install-recommends", "\\"}) words.erase(word);
  return words;
}

std::set<std::string> packagesToRun() {
  std::istringstream lines(readText(CANDELA_SOURCE_DIR "/cmake/packages.txt"));
  std::set<std::string> packages;
  for (std::string line; std::getline(lines, line);) {
    if (line.find('#') == std::string::npos) packages.insert(line);
  }
  return packages;
}

// Returns group 1 of the match in every line of `text` that matches `pattern` as a whole.
std::vector<std::string> captured(const std::string& text, const std::string& pattern) {
  const std::regex expression(pattern);
  std::istringstream lines(text);
  std::vector<std::string> found;
  std::smatch match;
  for (std::string line; std::getline(lines, line);) {
    if (std::regex_match(line, match, expression)) found.push_back(match[1]);
  }
  return found;
}

// The expected end of a block: `run`, or `exit N says "..."`.
struct Expectation {
  int exitCode = 0;
  std::string message;
};
std::optional<Expectation> expectationOf(const std::string& mark) {
  if (mark == "run") return Expectation{};
  std::smatch match;
  if (!std::regex_match(mark, match, std::regex("exit ([0-9]+) says \"(.+)\""))) return std::nullopt;
  return Expectation{std::stoi(match[1]), match[2]};
}

std::optional<std::string> fileOf(const std::string& mark) {
  const std::string start = "file ";
  return mark.starts_with(start) ? std::optional(mark.substr(start.size())) : std::nullopt;
}

// A repository as on the page: Candela with its build beside some scenes. Folders that are only read are links.
class Repository {
 public:
  Repository() {
    fs::create_directories(folder_.path("candela/build"));
    fs::create_symlink(CANDELA_SOURCE_DIR "/cmake", folder_.path("candela/cmake"));
    fs::create_symlink(fs::path(CANDELA_PROGRAM).parent_path(), folder_.path("candela/build/release"));
    fs::create_symlink(CANDELA_SOURCE_DIR "/scenes", folder_.path("scenes"));
    // A test installs nothing: a package that is missing fails it.
    fs::create_directory(folder_.path("bin"));
    folder_.write("bin/apt-get", "#!/bin/sh\necho \"this would have been installed: $*\"\nexit 1\n");
    fs::permissions(folder_.path("bin/apt-get"), fs::perms::owner_all);
  }

  ProgramResult run(const std::string& script) const {
    return runProgram("/bin/sh",
                      {"-c", "cd \"$0\" && PATH=\"$0/bin:$PATH\" && exec sh -eu -c \"$1\"", folder_.path(""), script});
  }
  void write(const std::string& name, const std::string& content) const { folder_.write(name, content); }
  bool has(const std::string& name) const { return fs::exists(folder_.path(name)); }

 private:
  TemporaryFolder folder_;
};

}  // namespace

TEST_CASE("every block of the page on continuous integration is checked") {
  const MarkedPage page = readPage();
  REQUIRE_FALSE(page.blocks.empty());
  for (const MarkedBlock& block : page.blocks) {
    INFO("docs/ci.md:" << block.line << ": mark \"" << block.mark << "\"");
    const bool known = block.mark == "workflow" || block.mark == "packages" || fileOf(block.mark) ||
                       expectationOf(block.mark);
    CHECK(known);
  }
  CHECK(captured(page.prose, "(    .*)").empty());  // indented code would be a block without a mark
}

TEST_CASE("the page on continuous integration installs the packages that Candela needs, and no others") {
  const MarkedPage page = readPage();
  CHECK(installedBy(theBlock(page, "packages").text) == packagesToRun());
  std::set<std::string> extra;
  for (const std::string& line : captured(theBlock(page, "workflow").text, " *- run: (apt-get .*)"))
    extra.merge(installedBy(line));
  CHECK(extra == std::set<std::string>{"ca-certificates", "git"});  // of the step that fetches the repository
}

TEST_CASE("the workflow runs the commands that the page on continuous integration runs") {
  const MarkedPage page = readPage();
  const std::string workflow = theBlock(page, "workflow").text;
  const std::vector<std::string> steps = captured(workflow, " *-? ?run:(.*)");
  REQUIRE_FALSE(steps.empty());
  std::string run;
  for (const MarkedBlock& block : page.blocks) run += block.mark == "run" ? block.text : "";
  for (const std::string& step : steps) {
    const std::string command = step.substr(std::min<std::size_t>(1, step.size()));
    INFO("run:" << step);
    CHECK((command.starts_with("apt-get ") || !captured(run, "(" + command + ")").empty()));
  }
}

TEST_CASE("every command of the page on continuous integration has the stated result") {
  const MarkedPage page = readPage();
  const Repository repository;
  for (const MarkedBlock& block : page.blocks) {
    if (const auto name = fileOf(block.mark)) repository.write(*name, block.text);
    const auto expected = expectationOf(block.mark);
    if (!expected) continue;
    const ProgramResult result = repository.run(block.text);
    INFO("docs/ci.md:" << block.line << "\n" << result.out << result.err);
    REQUIRE(result.exitCode == expected->exitCode);
    CHECK_THAT(result.out + result.err, Catch::Contains(expected->message));
  }
  for (const std::string& kept : captured(theBlock(page, "workflow").text, " *path: (.*)")) CHECK(repository.has(kept));
  // The table of result files has one or more file names at the start of each row.
  const std::vector<std::string> rows = captured(page.prose, "\\| (`[a-z]+\\.[a-z]+`.*) \\|.*");
  REQUIRE(rows.size() >= 5);
  for (const std::string& row : rows) {
    const std::regex quoted("`([a-z]+\\.[a-z]+)`");
    const std::string names = row.substr(0, row.find('|'));
    for (auto it = std::sregex_iterator(names.begin(), names.end(), quoted); it != std::sregex_iterator(); ++it) {
      INFO((*it)[1]);
      CHECK(repository.has("results/" + (*it)[1].str()));
    }
  }
}

TEST_CASE("the page on continuous integration states the program's exit codes and only options that exist") {
  const MarkedPage page = readPage();
  const std::string help = cli::helpText(std::nullopt);
  CHECK(captured(page.prose, "\\| ([0-9]+) \\|.*") ==
        captured(help.substr(help.find("Exit codes:")), " +([0-9]+)  .*"));

  const std::regex option("`[^`]*(--[a-z][a-z-]*)");
  const auto& table = cli::optionTable();
  for (auto it = std::sregex_iterator(page.prose.begin(), page.prose.end(), option); it != std::sregex_iterator();
       ++it) {
    const std::string name = (*it)[1];
    INFO(name);
    CHECK(std::ranges::any_of(table, [&](const cli::Option& o) { return o.name() == name; }));
  }
}

}  // namespace candela
