# Compiles for 64-bit ARM on another processor, with Debian's cross compiler and the packages in build/arm64-root
# (make_root.sh). Programs of this build, also those that generate sources, run in QEMU's user mode.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)

set(CMAKE_SYSROOT ${CMAKE_CURRENT_LIST_DIR}/../../build/arm64-root)
cmake_path(NORMAL_PATH CMAKE_SYSROOT)
if(NOT IS_DIRECTORY ${CMAKE_SYSROOT})
  message(FATAL_ERROR "The arm64 packages are not in ${CMAKE_SYSROOT}; this downloads them: sh cmake/arm64/make_root.sh")
endif()

find_program(CANDELA_ARM64_COMPILER aarch64-linux-gnu-g++)
find_program(CANDELA_ARM64_EMULATOR NAMES qemu-aarch64 qemu-aarch64-static)
if(NOT CANDELA_ARM64_COMPILER OR NOT CANDELA_ARM64_EMULATOR)
  message(FATAL_ERROR "The cross compiler or the emulator is not installed; on Debian: apt-get install g++-aarch64-linux-gnu qemu-user")
endif()
set(CMAKE_CXX_COMPILER ${CANDELA_ARM64_COMPILER})
set(CMAKE_CROSSCOMPILING_EMULATOR ${CANDELA_ARM64_EMULATOR} -L ${CMAKE_SYSROOT})

# Tools are the host's, and everything that is compiled or linked is in the folder.
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(CMAKE_LIBRARY_ARCHITECTURE aarch64-linux-gnu)
set(ENV{PKG_CONFIG_SYSROOT_DIR} ${CMAKE_SYSROOT})
set(ENV{PKG_CONFIG_LIBDIR} ${CMAKE_SYSROOT}/usr/lib/aarch64-linux-gnu/pkgconfig:${CMAKE_SYSROOT}/usr/share/pkgconfig)
