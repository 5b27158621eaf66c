# `cpack` in a build folder makes Debian packages for the release on which it runs:
#   candela      the program, its manual pages, completions, scenes and documentation
#   candela-dev  the libraries and headers for find_package(candela)
#   python3-candela  the Python module, where it is built
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_VENDOR "The Candela authors")
set(CANDELA_PACKAGE_CONTACT "The Candela authors <candela@candela.invalid>" CACHE STRING "Maintainer of the Debian packages")
set(CPACK_PACKAGE_CONTACT "${CANDELA_PACKAGE_CONTACT}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "path tracer for Vulkan with a reference tracer that checks it")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL program development)
if(CANDELA_BUILDS_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME candela)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "libvulkan1")  # opened when the program runs
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "mesa-vulkan-drivers, libglfw3")  # opened by candela view
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "Candela renders glTF, Mitsuba, OBJ, PLY, P3F and NFF scenes by path tracing on any
Vulkan 1.2 device, with or without ray-tracing hardware. An independent
reference tracer says whether the image is right.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME candela-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
    "libvulkan-dev, libglm-dev, libfmt-dev, libpugixml-dev, nlohmann-json3-dev, libpng-dev, libjpeg-dev, libopenexr-dev, libwebp-dev, zlib1g-dev, libstb-dev, libdraco-dev, libmeshoptimizer-dev")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "Libraries and headers of Candela, with which another program loads and
renders scenes.")

if(CANDELA_BUILDS_PYTHON)
  math(EXPR next_python "${Python_VERSION_MINOR} + 1")
endif()
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-candela)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    "libvulkan1, python3 (>= 3.${Python_VERSION_MINOR}~), python3 (<< 3.${next_python}), python3-numpy")
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "mesa-vulkan-drivers")
set(CPACK_COMPONENT_PYTHON_DESCRIPTION "Python module of Candela, a path tracer: renders files and arrays to
NumPy arrays, and says whether the image is right.")

# Every Debian package has a changelog and a copyright. The date is that of the version, so that equal sources give equal files.
foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  string(TOUPPER ${component} upper)
  set(name ${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
  set(file ${PROJECT_BINARY_DIR}/packages/${name}/changelog.Debian)
  file(WRITE ${file} "${name} (${PROJECT_VERSION}) unstable; urgency=medium\n\n  * Version ${PROJECT_VERSION}: see CHANGELOG.md in this folder.\n\n -- ${CPACK_PACKAGE_CONTACT}  Wed, 25 Nov 2026 12:00:00 +0000\n")
  execute_process(COMMAND gzip -9nkf ${file} COMMAND_ERROR_IS_FATAL ANY)
  install(FILES ${file}.gz DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${name} RENAME changelog.gz COMPONENT ${component})
  install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${name} RENAME copyright COMPONENT ${component})
endforeach()
file(WRITE ${PROJECT_BINARY_DIR}/packages/overrides "# The library contains tables and no code.\ncandela-dev: no-code-sections *libcandela_energy.a*\n")
install(FILES ${PROJECT_BINARY_DIR}/packages/overrides DESTINATION ${CMAKE_INSTALL_DATADIR}/lintian/overrides RENAME candela-dev COMPONENT development)
include(CPack)
