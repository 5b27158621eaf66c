// The supported extensions, and the extent of their support.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "host/formats/gltf/value.h"
#include "host/formats/loading/diagnostic_log.h"

namespace candela::gltf {

/// Complete, or `partly`: files load, and a warning names the parts that are not rendered yet.
enum class Support : std::uint8_t { none, partly, complete };

/// Returns the support that docs/gltf.md lists; decoders that this program was built without are `none`.
Support supportOf(std::string_view extension);

/// The extensions in `extensionsUsed`, and those of them that are supported partly or not at all.
struct UsedExtensions {
  std::vector<std::string> all;
  std::vector<std::string> partly;
  std::vector<std::string> unsupported;
};

/// Throws JsonError unless asset.version is 2.x and every required extension is supported. Warns of optional ones that
/// are not; with `lenient` also of required ones, unless the geometry cannot be read without them.
UsedExtensions checkAsset(const Value& root, bool lenient, scene::DiagnosticLog& log);

}  // namespace candela::gltf
