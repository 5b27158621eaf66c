// Checks attributes of OpenEXR headers before OpenEXR reads them.
#pragma once
#include <string_view>

#include "host/image/codecs.h"

namespace candela::image {

/// Throws FileError unless the value of an attribute of this type has the length that OpenEXR reads. For most types,
/// OpenEXR does not look at the stated size: if both differ, it would take the following bytes for another attribute,
/// and allocate whatever size that states.
void requireExrAttribute(std::string_view type, ByteView value);

}  // namespace candela::image
