// Lays out the text of --help in two columns.
#include "host/cli/help.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "host/cli/commands.h"
#include "host/cli/help_sections.h"
#include "host/cli/option_table.h"
#include "host/generate/kinds.h"

namespace candela::cli {
namespace {

constexpr std::size_t kTextColumn = 32;
constexpr std::size_t kLineWidth = 100;

// Returns `head` in the left column and `text`, wrapped, in the right column.
std::string twoColumns(const std::string& head, const std::string& text) {
  std::string out = "  " + head;
  std::size_t column = out.size();
  const auto startLine = [&] {
    out += "\n" + std::string(kTextColumn, ' ');
    column = kTextColumn;
  };
  if (column + 2 > kTextColumn) {
    startLine();
  } else {
    out.append(kTextColumn - column, ' ');
    column = kTextColumn;
  }
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (column > kTextColumn && column + 1 + word.size() > kLineWidth) startLine();
    if (column > kTextColumn) out += ' ';
    column += word.size() + (column > kTextColumn ? 1 : 0);
    out += word;
  }
  return out + "\n";
}

std::string optionHead(const Option& option) {
  std::string names = option.names;
  const std::size_t comma = names.find(',');
  if (comma != std::string::npos) names.replace(comma, 1, ", ");
  return option.isFlag() ? names : names + " " + option.metavar;
}

std::string optionText(const Option& option) {
  const bool named = option.isFlag() || option.defaultText.empty();
  return named ? option.help : fmt::format("{} (default: {})", option.help, option.defaultText);
}

std::string usageText(std::optional<Command> command) {
  std::string out = "Usage:\n";
  for (const CommandInfo& info : commandTable()) {
    if (command && info.command != *command) continue;
    out += twoColumns("candela " + info.usage, info.summary);
  }
  return out;
}

std::string groupText(const GroupTitle& title, std::optional<Command> command) {
  std::string rows;
  for (const Option& option : optionTable()) {
    if (option.group != title.group || (command && !option.isFor(*command))) continue;
    rows += twoColumns(optionHead(option), optionText(option));
  }
  return rows.empty() ? "" : fmt::format("\n{}:\n{}", title.title, rows);
}

std::string kindsText() {
  std::string out = "\nKinds, with their ranges of sizes and default sizes:\n";
  for (const generate::Kind& kind : generate::kindTable()) {
    const std::string head = fmt::format("{:<17}{} to {} ({})", kind.name, kind.minSize, kind.maxSize(),
                                         kind.defaultSize);
    out += twoColumns(head, std::string(kind.summary));
  }
  return out;
}

}  // namespace

std::string helpText(std::optional<Command> command) {
  std::string out = "Candela: a path tracer for Vulkan, with an independent reference tracer that checks it.\n\n";
  out += usageText(command);
  if (command == Command::generate) out += kindsText();
  for (const GroupTitle& title : groupTitles()) out += groupText(title, command);
  out += "\nExit codes:\n";
  for (const auto& [code, text] : exitCodeTexts()) out += fmt::format("  {:>2}  {}\n", static_cast<int>(code), text);
  return out;
}

}  // namespace candela::cli
