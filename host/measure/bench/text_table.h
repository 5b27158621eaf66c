// Tables as aligned text and as Markdown.
#pragma once
#include <string>
#include <vector>

namespace candela::bench {

/// Every row has as many cells as the header.
struct TextTable {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
};

/// Returns columns padded with blanks; the first is aligned to the left, all others to the right.
std::string toText(const TextTable& table);
/// Returns a Markdown table; `|` in cells is escaped.
std::string toMarkdown(const TextTable& table);

}  // namespace candela::bench
