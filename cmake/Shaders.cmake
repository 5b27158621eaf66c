# candela_shaders(TARGET NAME.comp...): compiles each compute shader, of this folder or else of shaders/, to SPIR-V
# (Vulkan 1.2) and embeds it in TARGET as `candela::spirv::NAME` (a std::span<const std::uint32_t>), declared in
# "spirv/NAME.h". Included files, looked for in shaders/, are tracked, so that editing one rebuilds the shaders that include it.
find_program(GLSLANG glslangValidator REQUIRED)

function(candela_shaders target)
  set(out_dir ${CMAKE_CURRENT_BINARY_DIR}/spirv)
  file(MAKE_DIRECTORY ${out_dir})
  foreach(file ${ARGN})
    get_filename_component(name ${file} NAME_WE)
    set(source ${CMAKE_CURRENT_SOURCE_DIR}/${file})
    if(NOT EXISTS ${source})
      set(source ${PROJECT_SOURCE_DIR}/shaders/${file})
    endif()
    set(spv ${out_dir}/${name}.spv)
    add_custom_command(
      OUTPUT ${spv}
      COMMAND ${GLSLANG} --quiet --target-env vulkan1.2 -I${PROJECT_SOURCE_DIR}/shaders --depfile ${spv}.d
              -o ${spv} ${source}
      MAIN_DEPENDENCY ${source}
      DEPFILE ${spv}.d
      COMMENT "SPIR-V ${file}"
      VERBATIM)
    add_custom_command(
      OUTPUT ${out_dir}/${name}.h ${out_dir}/${name}.cpp
      COMMAND ${CMAKE_COMMAND} -DNAME=${name} -DSPV=${spv} -DOUT=${out_dir}/${name}
              -P ${PROJECT_SOURCE_DIR}/cmake/EmbedSpirv.cmake
      DEPENDS ${spv} ${PROJECT_SOURCE_DIR}/cmake/EmbedSpirv.cmake
      COMMENT "Embedding ${file}"
      VERBATIM)
    target_sources(${target} PRIVATE ${out_dir}/${name}.cpp ${out_dir}/${name}.h)
    set_property(GLOBAL APPEND PROPERTY CANDELA_SPIRV ${spv})
    set_property(TARGET ${target} APPEND PROPERTY CANDELA_SPIRV ${spv})
  endforeach()
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_BINARY_DIR}>)
endfunction()

# candela_spirv_hash(TARGET): embeds one hash of all shaders of TARGET so far, as
# `candela::spirv::hash` (a std::string_view of 64 hexadecimal digits) in "spirv/hash.h".
function(candela_spirv_hash target)
  get_target_property(modules ${target} CANDELA_SPIRV)
  set(header ${CMAKE_CURRENT_BINARY_DIR}/spirv/hash.h)
  add_custom_command(
    OUTPUT ${header}
    COMMAND ${CMAKE_COMMAND} "-DSPV=${modules}" -DOUT=${header} -P ${PROJECT_SOURCE_DIR}/cmake/HashSpirv.cmake
    DEPENDS ${modules} ${PROJECT_SOURCE_DIR}/cmake/HashSpirv.cmake
    COMMENT "Hashing SPIR-V"
    VERBATIM)
  target_sources(${target} PRIVATE ${header})
endfunction()

# One test spirv_val_NAME for every shader that has been passed to candela_shaders so far, and one test of the capabilities of all.
function(candela_spirv_tests)
  find_program(SPIRV_VAL spirv-val REQUIRED)
  find_package(Python3 REQUIRED COMPONENTS Interpreter)
  get_property(modules GLOBAL PROPERTY CANDELA_SPIRV)
  list(REMOVE_DUPLICATES modules)
  foreach(spv ${modules})
    get_filename_component(name ${spv} NAME_WE)
    add_test(NAME spirv_val_${name} COMMAND ${SPIRV_VAL} --target-env vulkan1.2 ${spv})
  endforeach()
  add_test(NAME "no module reads values of other invocations of its subgroup"
    COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tests/architecture/test_subgroups.py ${modules})
endfunction()
