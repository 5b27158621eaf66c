// The version of Candela.
#pragma once
#include <string>

namespace candela {

/// E.g. "0.1.0", as in the CMake project.
std::string versionText();

/// Returns everything on which floating-point results may depend: the compiler, the C library and the instruction set,
/// e.g. "GCC 12.2.0, glibc 2.36, x86-64 with FMA".
std::string toolchainText();

}  // namespace candela
