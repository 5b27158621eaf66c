# candela_embed_text(TARGET FOLDER/NAME.ext...): embeds text files, given from the project's root, in TARGET as
# `candela::embedded::NAME` (a std::string_view), declared in "embedded/NAME.h".
function(candela_embed_text target)
  set(out_dir ${CMAKE_CURRENT_BINARY_DIR}/embedded)
  file(MAKE_DIRECTORY ${out_dir})
  foreach(file ${ARGN})
    get_filename_component(name ${file} NAME_WE)
    add_custom_command(
      OUTPUT ${out_dir}/${name}.h ${out_dir}/${name}.cpp
      COMMAND ${CMAKE_COMMAND} -DNAME=${name} -DTEXT=${PROJECT_SOURCE_DIR}/${file} -DOUT=${out_dir}/${name}
              -P ${PROJECT_SOURCE_DIR}/cmake/WriteEmbeddedText.cmake
      DEPENDS ${PROJECT_SOURCE_DIR}/${file} ${PROJECT_SOURCE_DIR}/cmake/WriteEmbeddedText.cmake
      COMMENT "Embedding ${file}"
      VERBATIM)
    target_sources(${target} PRIVATE ${out_dir}/${name}.cpp ${out_dir}/${name}.h)
  endforeach()
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_BINARY_DIR}>)
endfunction()
