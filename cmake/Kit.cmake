# The target `kit` makes candela-VERSION-linux-ARCHITECTURE.tar.xz in the build folder: the program and its scenes for any Linux with the
# same or a newer C library, and a script that measures a device. It builds the libraries that Debian has no archives of.
add_custom_target(kit
  COMMAND ${CMAKE_COMMAND} -E env CXX=${CMAKE_CXX_COMPILER}
          sh ${PROJECT_SOURCE_DIR}/cmake/kit/make_kit.sh ${PROJECT_BINARY_DIR} ${PROJECT_VERSION}
  USES_TERMINAL
  COMMENT "Making the kit")
