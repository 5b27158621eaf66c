// Lays out the text of --help in two columns.
#include "host/app/cli/help.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>

#include "host/app/cli/commands.h"
#include "host/app/cli/help_sections.h"
#include "host/app/cli/option_table.h"
#include "host/app/cli/wrapped_lines.h"
#include "host/scene/generate/kinds.h"

namespace candela::cli {
namespace {

constexpr std::size_t kTextColumn = 32;

// Returns `head` in the left column and `text`, wrapped, in the right column.
std::string twoColumns(const std::string& head, const std::string& text, std::size_t width) {
  WrappedLines lines(width);
  lines.moveTo(2, 6);
  lines.addColumns(head);
  lines.moveTo(kTextColumn, kTextColumn);
  lines.add(text);
  return lines.text();
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

std::string usageText(std::optional<Command> command, std::size_t width) {
  std::string out = "Usage:\n";
  for (const CommandInfo& info : commandTable()) {
    if (command && info.command != *command) continue;
    out += twoColumns("candela " + info.usage, info.summary, width);
  }
  return out;
}

std::string groupText(const GroupTitle& title, std::optional<Command> command, std::size_t width) {
  std::string rows;
  for (const Option& option : optionTable()) {
    if (option.group != title.group || (command && !option.isFor(*command))) continue;
    rows += twoColumns(optionHead(option), optionText(option), width);
  }
  if (rows.empty()) return "";
  WrappedLines lines(width);
  lines.add(std::string(title.title) + ":");
  return "\n" + lines.text() + rows;
}

std::string kindsText(std::size_t width) {
  std::string out = "\nKinds, with their ranges of sizes and default sizes:\n";
  for (const generate::Kind& kind : generate::kindTable()) {
    const std::string head = fmt::format("{:<17}{} to {} ({})", kind.name, kind.minSize, kind.maxSize(),
                                         kind.defaultSize);
    out += twoColumns(head, std::string(kind.summary), width);
  }
  return out;
}

}  // namespace

std::size_t helpWidth() {
  winsize size{};
  if (::isatty(STDOUT_FILENO) == 0 || ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0) return kMaxHelpWidth;
  return std::clamp<std::size_t>(size.ws_col, kMinHelpWidth, kMaxHelpWidth);
}

std::string helpText(std::optional<Command> command, std::size_t width) {
  WrappedLines title(width);
  title.add("Candela: a path tracer for Vulkan, with an independent reference tracer that checks it.");
  std::string out = title.text() + "\n" + usageText(command, width);
  if (command == Command::generate) out += kindsText(width);
  for (const GroupTitle& group : groupTitles()) out += groupText(group, command, width);
  out += "\nExit codes:\n";
  for (const auto& [code, text] : exitCodeTexts()) {
    WrappedLines lines(width);
    lines.moveTo(2, 6);
    lines.addColumns(fmt::format("{:>2}", static_cast<int>(code)));
    lines.moveTo(6, 6);
    lines.add(text);
    out += lines.text();
  }
  return out;
}

}  // namespace candela::cli
