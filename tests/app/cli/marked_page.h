// A Markdown page whose fenced blocks have a comment above them, invisible to readers, that tells a test what to
// do with them.
#pragma once
#include <string>
#include <vector>

namespace candela {

struct MarkedBlock {
  std::string mark;      ///< of `<!-- ci: MARK -->` on the line above; empty if there is none
  std::string language;  ///< after the opening fence
  std::string text;
  std::size_t line = 0;  ///< of the opening fence, from 1
};

struct MarkedPage {
  std::vector<MarkedBlock> blocks;
  std::string prose;  ///< everything outside of blocks
};

/// Throws std::runtime_error for a block that does not end.
MarkedPage readMarkedPage(const std::string& markdown);

}  // namespace candela
