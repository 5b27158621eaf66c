# candela_shaders(TARGET NAME.comp...): compiles each compute shader of shaders/ to SPIR-V (Vulkan 1.2) and embeds it
# in TARGET as `candela::spirv::NAME` (a std::span<const std::uint32_t>), declared in "spirv/NAME.h".
# Included files are tracked, so that editing a .glsl rebuilds what reads it.
find_program(GLSLANG glslangValidator REQUIRED)

function(candela_shaders target)
  set(out_dir ${CMAKE_CURRENT_BINARY_DIR}/spirv)
  file(MAKE_DIRECTORY ${out_dir})
  foreach(source ${ARGN})
    get_filename_component(name ${source} NAME_WE)
    set(spv ${out_dir}/${name}.spv)
    add_custom_command(
      OUTPUT ${spv}
      COMMAND ${GLSLANG} --quiet --target-env vulkan1.2 -I${CMAKE_SOURCE_DIR}/shaders --depfile ${spv}.d
              -o ${spv} ${CMAKE_SOURCE_DIR}/shaders/${source}
      MAIN_DEPENDENCY ${CMAKE_SOURCE_DIR}/shaders/${source}
      DEPFILE ${spv}.d
      COMMENT "SPIR-V ${source}"
      VERBATIM)
    add_custom_command(
      OUTPUT ${out_dir}/${name}.h ${out_dir}/${name}.cpp
      COMMAND ${CMAKE_COMMAND} -DNAME=${name} -DSPV=${spv} -DOUT=${out_dir}/${name}
              -P ${CMAKE_SOURCE_DIR}/cmake/EmbedSpirv.cmake
      DEPENDS ${spv} ${CMAKE_SOURCE_DIR}/cmake/EmbedSpirv.cmake
      VERBATIM)
    target_sources(${target} PRIVATE ${out_dir}/${name}.cpp ${out_dir}/${name}.h)
  endforeach()
  target_include_directories(${target} PUBLIC ${CMAKE_CURRENT_BINARY_DIR})
endfunction()
