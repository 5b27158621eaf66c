// Formats tables as aligned text and as Markdown.
#include "host/measure/bench/text_table.h"

#include <fmt/format.h>

#include <algorithm>

namespace candela::bench {
namespace {

std::vector<std::size_t> columnWidths(const TextTable& table) {
  std::vector<std::size_t> widths;
  for (const std::string& title : table.header) widths.push_back(title.size());
  for (const auto& row : table.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  return widths;
}

std::string textRow(const std::vector<std::string>& cells, const std::vector<std::size_t>& widths) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    line += i == 0 ? fmt::format("{:<{}}", cells[i], widths[i]) : fmt::format("  {:>{}}", cells[i], widths[i]);
  }
  return line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
}

std::string markdownRow(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) {
    std::string escaped;
    for (const char character : cell) escaped += character == '|' ? "\\|" : std::string(1, character);
    line += " " + escaped + " |";
  }
  return line + "\n";
}

}  // namespace

std::string toText(const TextTable& table) {
  const std::vector<std::size_t> widths = columnWidths(table);
  std::string out = textRow(table.header, widths);
  for (const auto& row : table.rows) out += textRow(row, widths);
  return out;
}

std::string toMarkdown(const TextTable& table) {
  std::string out = markdownRow(table.header) + "|";
  for (std::size_t i = 0; i < table.header.size(); ++i) out += i == 0 ? "---|" : "---:|";
  out += "\n";
  for (const auto& row : table.rows) out += markdownRow(row);
  return out;
}

}  // namespace candela::bench
