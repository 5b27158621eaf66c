// The choice of the channels of an EXR file that are its picture.
#pragma once
#include <OpenEXR/ImfHeader.h>

#include <string>
#include <vector>

namespace candela::image {

struct ExrColours {
  std::vector<std::string> names;  ///< of red, green and blue, or of one channel that is grey
  std::string alpha;               ///< name of the channel; empty if there is none
  std::string warning;             ///< what the choice assumes; empty if the file says it
};

/// Returns whether the file has a channel of this name with a value for each pixel.
bool hasFullChannel(const Imf::Header& header, const std::string& name);

/// Returns R, G and B; else Y alone; else the colours of the only layer that has them; else the only channel. Throws
/// FileError, which names what the file has instead: several layers, luminance and chroma, or other channels.
ExrColours chooseColours(const Imf::Header& header);

}  // namespace candela::image
