// Recognises devices without hardware behind them.
#include "host/trace/vulkan/stand_in.h"

#include <algorithm>
#include <catch2/catch.hpp>

namespace candela::vulkan {

TEST_CASE("a library of Mesa that replaces the kernel driver is named") {
  const std::vector<std::string> libraries{"/lib/libc.so.6", "/usr/lib/libamdgpu_noop_drm_shim.so", "/lib/libdrm.so.2"};
  CHECK(standInFor("AMD Radeon RX 6800", libraries) == "libamdgpu_noop_drm_shim.so");
}

TEST_CASE("null hardware is a stand-in, and a device with the usual libraries is none") {
  CHECK(standInFor("Null hardware (RADV NAVI21)", {}) == "RADV_FORCE_FAMILY");
  CHECK(standInFor("AMD Radeon RX 6800 (RADV NAVI21)", {"/lib/libdrm.so.2", ""}).empty());
  CHECK(standInFor("AMD Radeon RX 6800 (RADV NAVI21)", loadedLibraries()).empty());
}

TEST_CASE("the libraries of a process include that of the language") {
  CHECK(std::ranges::any_of(loadedLibraries(),
                            [](const std::string& library) { return library.find("libc.so") != std::string::npos; }));
}

}  // namespace candela::vulkan
