// Lines and columns of offsets in a text.
#pragma once
#include <cstddef>
#include <string_view>

#include "host/formats/loading/diagnostic.h"

namespace candela::scene {

/// Returns the position of the byte at `offset`, at most text.size(). Lines end with LF, CR LF or CR. It reads the text
/// from its beginning: for messages.
Position positionIn(std::string_view text, std::size_t offset);

}  // namespace candela::scene
