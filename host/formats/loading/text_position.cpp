// Counts lines.
#include "host/formats/loading/text_position.h"

namespace candela::scene {

Position positionIn(std::string_view text, std::size_t offset) {
  std::uint32_t line = 1;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < offset; ++i) {
    const bool isBeforeLineFeed = i + 1 < text.size() && text[i + 1] == '\n';
    if (text[i] != '\n' && (text[i] != '\r' || isBeforeLineFeed)) continue;
    ++line;
    begin = i + 1;
  }
  return {line, static_cast<std::uint32_t>(offset - begin + 1)};
}

}  // namespace candela::scene
