// Manual pages and completions name every command, option and value of the tables.
#include <catch2/catch.hpp>
#include <regex>

#include "host/app/cli/commands.h"
#include "host/app/manuals/completion_words.h"
#include "host/app/manuals/completions.h"
#include "host/app/manuals/manual_page.h"

using namespace candela;

namespace {

std::string inRoff(const std::string& text) { return std::regex_replace(text, std::regex("-"), "\\-"); }

// Returns the lines of `text` that contain `word`.
std::string linesWith(const std::string& text, const std::string& word) {
  std::string out;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    if (line.find(word) != std::string::npos) out += line + "\n";
  }
  return out;
}

template <class Check>
void forEachOption(Check&& check) {
  for (const cli::CommandInfo& info : cli::commandTable()) {
    for (const cli::Option& option : cli::optionTable()) {
      if (option.isFor(info.command)) check(info, option);
    }
  }
}

}  // namespace

TEST_CASE("a command's manual page has its options, and no others") {
  for (const cli::CommandInfo& info : cli::commandTable()) {
    const std::string page = manuals::manualPage(info.command);
    for (const cli::Option& option : cli::optionTable()) {
      CAPTURE(info.name, option.names);
      const std::string tag = "\\fB" + inRoff(option.name()) + "\\fR";
      bool isExpected = false;
      for (const cli::Option& row : cli::optionTable()) {
        isExpected = isExpected || (row.name() == option.name() && row.isFor(info.command));
      }
      CHECK((page.find(tag) != std::string::npos) == isExpected);
    }
  }
}

TEST_CASE("the program's manual page refers to every command") {
  const std::string page = manuals::manualPage({});
  for (const cli::CommandInfo& info : cli::commandTable()) {
    CAPTURE(info.name);
    CHECK(page.find("\\fBcandela\\-" + info.name + "\\fR(1)") != std::string::npos);
  }
}

TEST_CASE("roff sees no request in what it prints") {
  for (const cli::CommandInfo& info : cli::commandTable()) {
    std::istringstream page(manuals::manualPage(info.command));
    for (std::string line; std::getline(page, line);) {
      CAPTURE(info.name, line);
      CHECK(std::regex_search(line, std::regex("^(\\.(TH|SH|SS|TP)|[^.'])")));
    }
  }
}

TEST_CASE("the completion of fish has every option of every command") {
  const std::string script = manuals::fishCompletion();
  forEachOption([&](const cli::CommandInfo& info, const cli::Option& option) {
    CAPTURE(info.name, option.names);
    const bool isDefault = info.command == cli::Command::render;
    const std::string lines = linesWith(
        script, isDefault ? "'not __fish_seen_subcommand_from" : "'__fish_seen_subcommand_from " + info.name + "'");
    CHECK(lines.find(" -l " + option.name().substr(2) + " ") != std::string::npos);
  });
}

TEST_CASE("the completion of zsh has every option of every command") {
  const std::string script = manuals::zshCompletion();
  forEachOption([&](const cli::CommandInfo& info, const cli::Option& option) {
    CAPTURE(info.name, option.names);
    const std::size_t begin = script.find("_candela_" + info.name + "() {");
    REQUIRE(begin != std::string::npos);
    const std::string body = script.substr(begin, script.find("\n}\n", begin) - begin);
    CHECK(body.find("'*" + option.name() + "[") != std::string::npos);
  });
}

TEST_CASE("values are those that a metavar lists") {
  cli::Option option;
  option.metavar = "on|off";
  CHECK(manuals::valuesOf(option) == std::vector<std::string>{"on", "off"});
  option.metavar = "cpu|N|SUBSTRING";
  CHECK(manuals::valuesOf(option) == std::vector<std::string>{"cpu"});
  option.metavar = "WxH";
  CHECK(manuals::valueKind(option) == manuals::ValueKind::other);
}
