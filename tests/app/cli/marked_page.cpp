// Parses a Markdown page with marked blocks.
#include "tests/app/cli/marked_page.h"

#include <sstream>
#include <stdexcept>

namespace candela {
namespace {

const std::string kFence = "```";

std::string markOf(const std::string& line) {
  const std::string start = "<!-- ci: ", end = " -->";
  if (!line.starts_with(start) || !line.ends_with(end)) return "";
  return line.substr(start.size(), line.size() - start.size() - end.size());
}

}  // namespace

MarkedPage readMarkedPage(const std::string& markdown) {
  MarkedPage page;
  std::istringstream lines(markdown);
  std::string previous;
  std::size_t number = 0;
  bool inside = false;
  for (std::string line; std::getline(lines, line); previous = line) {
    ++number;
    if (line.starts_with(kFence)) {
      if (!inside) page.blocks.push_back({markOf(previous), line.substr(kFence.size()), "", number});
      inside = !inside;
      continue;
    }
    (inside ? page.blocks.back().text : page.prose) += line + "\n";
  }
  if (inside) throw std::runtime_error("a block of the page does not end");
  return page;
}

}  // namespace candela
