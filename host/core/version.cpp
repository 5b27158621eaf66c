// The version comes from the build. Nothing else about the build environment is included, so that builds are
// reproducible.
#include "host/core/version.h"

namespace candela {

std::string versionText() { return CANDELA_VERSION; }

}  // namespace candela
