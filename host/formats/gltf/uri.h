// URIs of buffers and images: data in the URI itself, or a relative path.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

#include "host/formats/gltf/value.h"

namespace candela::gltf {

/// Returns whether the URI contains its data: "data:...".
bool isDataUri(std::string_view uri);

/// Returns the bytes of a data URI (RFC 2397): characters with %XX decoded, which are then decoded from base64 (RFC
/// 4648) if the URI says so. Throws JsonError at the place of `uri` if there is no comma, or the data cannot be
/// decoded.
std::string decodeDataUri(const Value& uri);

/// Returns the relative path of a URI, with %XX decoded. Throws JsonError if it has a scheme ("http:"), an
/// incomplete %XX or a zero byte.
std::filesystem::path decodePath(const Value& uri);

}  // namespace candela::gltf
