# With CANDELA_STATIC_LIBRARIES, the program needs only the C library and, at run time, the Vulkan loader: all other libraries are
# linked from their archives. Their symbols and those of the C++ library stay hidden, since drivers load the host's libraries into the
# same process.
option(CANDELA_STATIC_LIBRARIES "Link all libraries but the C library from archives" OFF)
if(CANDELA_STATIC_LIBRARIES)
  set(CMAKE_FIND_LIBRARY_SUFFIXES .a .so)  # CMake looks for the Vulkan loader, which is not linked
  add_link_options(-static-libstdc++ -static-libgcc LINKER:--exclude-libs,ALL)
endif()
