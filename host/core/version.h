// The version of Candela.
#pragma once
#include <string>

namespace candela {

/// E.g. "0.1.0", as in the CMake project.
std::string versionText();

}  // namespace candela
