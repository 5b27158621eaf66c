// Writes roff: the macros TH, SH, SS, TP and the fonts B, I.
#include "host/app/manuals/manual_page.h"

#include <fmt/format.h>

#include <string>

#include "host/app/cli/commands.h"
#include "host/app/cli/help_sections.h"
#include "host/app/cli/option_table.h"
#include "host/base/version.h"
#include "host/scene/generate/kinds.h"

namespace candela::manuals {
namespace {

/// Returns text that roff prints literally: without requests and escapes, and with minus signs instead of hyphens.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char character : text) {
    if (character == '\\') {
      out += "\\e";
    } else if (character == '-') {
      out += "\\-";
    } else {
      out += character;
    }
  }
  return out.starts_with('.') || out.starts_with('\'') ? "\\&" + out : out;
}

/// Returns escaped text in which words between backquotes are bold.
std::string withLiterals(const std::string& text) {
  std::string out;
  bool isLiteral = false;
  for (const char character : escaped(text)) {
    if (character == '`') {
      isLiteral = !isLiteral;
      out += isLiteral ? "\\fB" : "\\fR";
    } else {
      out += character;
    }
  }
  return out;
}

std::string capitalised(std::string phrase) {
  if (!phrase.empty() && phrase.front() >= 'a' && phrase.front() <= 'z') phrase.front() += 'A' - 'a';
  return phrase;
}

std::string optionTag(const cli::Option& option) {
  std::string tag;
  for (std::size_t first = 0; first <= option.names.size();) {
    const std::size_t end = std::min(option.names.find(',', first), option.names.size());
    if (!tag.empty()) tag += ", ";
    tag += "\\fB" + escaped(option.names.substr(first, end - first)) + "\\fR";
    first = end + 1;
  }
  return option.isFlag() ? tag : tag + " \\fI" + escaped(option.metavar) + "\\fR";
}

std::string optionText(const cli::Option& option) {
  std::string text = capitalised(withLiterals(option.help)) + ".";
  if (option.isFlag() || option.defaultText.empty()) return text;
  return text + " Default: " + withLiterals(option.defaultText) + ".";
}

std::string optionSections(std::optional<cli::Command> command) {
  std::string out;
  for (const auto& [group, title] : cli::groupTitles()) {
    std::string rows;
    for (const cli::Option& option : cli::optionTable()) {
      const bool isShown = command ? option.isFor(*command) : option.group == cli::OptionGroup::general;
      if (option.group == group && isShown) rows += ".TP\n" + optionTag(option) + "\n" + optionText(option) + "\n";
    }
    if (!rows.empty()) out += ".SS " + escaped(title) + "\n" + rows;
  }
  return out;
}

std::string kindSection() {
  std::string out = ".SH KINDS\n";
  for (const generate::Kind& kind : generate::kindTable()) {
    out += fmt::format(".TP\n\\fB{}\\fR\n{}. Size {} to {}, default: {}.\n", escaped(std::string(kind.name)),
                       capitalised(withLiterals(std::string(kind.summary))), kind.minSize, kind.maxSize(),
                       kind.defaultSize);
  }
  return out;
}

std::string commandSection() {
  std::string out = ".SH COMMANDS\nEvery command has a page of its own.\n";
  for (const cli::CommandInfo& info : cli::commandTable()) {
    out += fmt::format(".TP\n\\fBcandela\\-{}\\fR(1)\n{}.\n", info.name, capitalised(withLiterals(info.summary)));
  }
  return out;
}

std::string exitSection() {
  std::string out = ".SH EXIT STATUS\n";
  for (const auto& [code, text] : cli::exitCodeTexts()) {
    out += fmt::format(".TP\n{}\n{}.\n", static_cast<int>(code), capitalised(escaped(text)));
  }
  return out;
}

std::string head(const std::string& name, const std::string& summary, const std::string& usage) {
  return fmt::format(
      ".TH {} 1 \"\" \"Candela {}\" \"Candela\"\n.SH NAME\n{} \\- {}\n.SH SYNOPSIS\n\\fBcandela\\fR {}\n",
      escaped(name), versionText(), escaped(name), withLiterals(summary), escaped(usage));
}

}  // namespace

std::string pageName(std::optional<cli::Command> command) {
  return command ? "candela-" + cli::commandInfo(*command).name : "candela";
}

std::string manualPage(std::optional<cli::Command> command) {
  const std::string name = pageName(command);
  if (!command) {
    return head(name, "path tracer for Vulkan, with a reference tracer that checks it", "COMMAND [OPTION]...") +
           ".SH DESCRIPTION\nCandela renders scenes by path tracing on any Vulkan device. An independent reference "
           "tracer on the processor says whether the image is right.\n" +
           commandSection() + ".SH OPTIONS\n" + optionSections(command) + exitSection();
  }
  const cli::CommandInfo& info = cli::commandInfo(*command);
  return head(name, info.summary, info.usage + " [OPTION]...") + ".SH OPTIONS\n" + optionSections(command) +
         (command == cli::Command::generate ? kindSection() : "") + exitSection() +
         ".SH SEE ALSO\n\\fBcandela\\fR(1)\n";
}

}  // namespace candela::manuals
