// A Vulkan driver that crashes when the loader queries its first function.
#include <cstdio>
#include <cstdlib>

using Function = void (*)();

extern "C" Function vk_icdGetInstanceProcAddr(void*, const char*) {
  std::fputs("crashing_driver: assertion failed\n", stderr);
  std::abort();
}
