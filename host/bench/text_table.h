// Tables for people: aligned text, and Markdown.
#pragma once
#include <string>
#include <vector>

namespace candela::bench {

/// Every row has as many cells as the header.
struct TextTable {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
};

/// Columns padded with blanks, the first to the right of its text, numbers and all other columns to the left.
std::string toText(const TextTable& table);
/// The same as a Markdown table; `|` in cells is escaped.
std::string toMarkdown(const TextTable& table);

}  // namespace candela::bench
