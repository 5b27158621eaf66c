// The text of --help, and the pages that quote it and the list of packages.
#include "host/app/cli/help.h"

#include <catch2/catch.hpp>
#include <iterator>
#include <sstream>

#include "host/scene/generate/kinds.h"
#include "tests/app/cli/run_program.h"

namespace candela::cli {
namespace {

// The text between "```text" and "```" after a marker in a page of docs/.
std::string quotedBlock(const std::string& page, const std::string& marker) {
  const std::string text = readText(CANDELA_SOURCE_DIR "/docs/" + page);
  const std::string opening = "```text\n";
  const std::size_t start = text.find(opening, text.find("<!-- " + marker));
  REQUIRE(start != std::string::npos);
  return text.substr(start + opening.size(), text.find("```\n", start + 1) - start - opening.size());
}

}  // namespace

TEST_CASE("the documentation quotes the help") {
  CHECK(quotedBlock("command-line.md", "help") == helpText(std::nullopt));
}

TEST_CASE("the documentation quotes the list of packages") {
  std::istringstream lines(readText(CANDELA_SOURCE_DIR "/cmake/packages.txt"));
  std::string packages;
  for (std::string line; std::getline(lines, line);) {
    if (line.front() != '#') packages += line + "\n";
  }
  CHECK(quotedBlock("building.md", "packages") == packages);
}

TEST_CASE("the help of generate has every kind with its sizes, and only its own options") {
  const std::string help = helpText(Command::generate);
  for (const generate::Kind& kind : generate::kindTable()) {
    CHECK(help.find("\n  " + std::string(kind.name) + " ") != std::string::npos);
  }
  CHECK(help.find("balls            1 to 7 (4)") != std::string::npos);
  CHECK(help.find("--size N") != std::string::npos);
  CHECK(help.find("--size WxH") == std::string::npos);
  CHECK(helpText(Command::render).find("--size N") == std::string::npos);
  CHECK(helpText(Command::render).find("balls") == std::string::npos);
}

TEST_CASE("the help is wrapped to the width of the terminal, with the same words") {
  const auto wordsOf = [](const std::string& text) {
    std::istringstream words(text);
    return std::vector<std::string>(std::istream_iterator<std::string>(words), {});
  };
  for (const std::optional<Command> command : {std::optional<Command>(), std::optional(Command::generate)}) {
    const std::string narrow = helpText(command, kMinHelpWidth);
    std::istringstream lines(narrow);
    for (std::string line; std::getline(lines, line);) CHECK(line.size() <= kMinHelpWidth);
    CHECK(wordsOf(narrow) == wordsOf(helpText(command)));
  }
}

TEST_CASE("the help fits into 100 columns and states every exit code") {
  const std::string help = helpText(std::nullopt) + helpText(Command::generate);
  std::istringstream lines(help);
  for (std::string line; std::getline(lines, line);) CHECK(line.size() <= 100);
  for (const char* code : {"   0  ", "   1  ", "   2  ", "   3  ", "   4  ", "   5  ", "   6  ", "   7  ", "  70  "}) {
    CHECK(help.find(std::string("\n") + code) != std::string::npos);
  }
}

}  // namespace candela::cli
