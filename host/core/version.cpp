// The version that the build passes in; nothing else of the build's surroundings, so that builds repeat.
#include "host/core/version.h"

namespace candela {

std::string versionText() { return CANDELA_VERSION; }

}  // namespace candela
