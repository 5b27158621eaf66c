# The files of `cmake --install`: the program, and the libraries of the renderer with their headers, for other projects:
#   find_package(candela REQUIRED)
#   target_link_libraries(mine PRIVATE candela::candela)
include(CMakePackageConfigHelpers)

# The one target that other projects link.
add_library(candela_all INTERFACE)
add_library(candela::candela ALIAS candela_all)
set_target_properties(candela_all PROPERTIES EXPORT_NAME candela)
target_link_libraries(candela_all INTERFACE candela_formats candela_scene candela_image candela_film candela_generate candela_reference candela_device candela_job)

get_property(libraries GLOBAL PROPERTY CANDELA_EXPORTED)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/candela)
install(TARGETS candela RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
install(TARGETS candela_all ${libraries} EXPORT candela ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
install(EXPORT candela NAMESPACE candela:: FILE candelaTargets.cmake DESTINATION ${package} COMPONENT development)
foreach(folder ${CANDELA_LIBRARY_FOLDERS} scene/coincidence trace/reference/rounding)
  file(GLOB headers ${PROJECT_SOURCE_DIR}/host/${folder}/*.h)
  install(FILES ${headers} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/candela/host/${folder} COMPONENT development)
endforeach()
install(DIRECTORY lists DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/candela COMPONENT development FILES_MATCHING PATTERN "*.h")

# The libraries that host/formats/gltf was built with, if any.
set(CANDELA_DECODER_DEPENDENCIES "")
foreach(decoder draco meshoptimizer)
  if(TARGET ${decoder}::${decoder})
    string(APPEND CANDELA_DECODER_DEPENDENCIES "find_dependency(${decoder})\n")
  endif()
endforeach()
configure_package_config_file(cmake/candelaConfig.cmake.in candelaConfig.cmake INSTALL_DESTINATION ${package})
write_basic_package_version_file(candelaConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/candelaConfig.cmake ${PROJECT_BINARY_DIR}/candelaConfigVersion.cmake DESTINATION ${package} COMPONENT development)

install(FILES README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
install(DIRECTORY scenes DESTINATION ${CMAKE_INSTALL_DATADIR}/candela COMPONENT program)
install(DIRECTORY host/drivers/conformance/baselines/ DESTINATION ${CMAKE_INSTALL_DATADIR}/candela/conformance COMPONENT program)
install(FILES cmake/desktop/candela.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications COMPONENT program)
install(FILES cmake/desktop/candela.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages COMPONENT program)
