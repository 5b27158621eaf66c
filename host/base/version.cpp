// The version comes from the build. Nothing else but the compiler is included, so that builds are
// reproducible.
#include "host/base/version.h"

#if __has_include(<gnu/libc-version.h>)
#include <gnu/libc-version.h>
#endif

namespace candela {

std::string versionText() { return CANDELA_VERSION; }

std::string toolchainText() {
#if defined(__clang__)
  const std::string compiler = "Clang " __clang_version__;
#elif defined(__GNUC__)
  const std::string compiler = "GCC " __VERSION__;
#else
  const std::string compiler = "another compiler";
#endif
#if defined(__GLIBC__)
  const std::string library = std::string(", glibc ") + gnu_get_libc_version();
#else
  const std::string library;
#endif
#if defined(__x86_64__)
  // The C library computes sine, logarithm and others by fused multiplication and addition where the CPU has it.
  return compiler + library + (__builtin_cpu_supports("fma") != 0 ? ", x86-64 with FMA" : ", x86-64");
#elif defined(__aarch64__)
  return compiler + library + ", AArch64";
#else
  return compiler + library;
#endif
}

}  // namespace candela
