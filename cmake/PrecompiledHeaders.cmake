# Two precompiled headers, one for the libraries and one for the tests, only of headers of the standard library and of
# other projects, so that no edit of the project's own headers invalidates them. No source file relies on them.

# candela_precompile(TARGET SHARED): compiles TARGET's sources after the precompiled header of the target SHARED. At the end
# of the calling directory, so that a target that has its own precompiled header by then keeps it.
function(candela_precompile target shared)
  cmake_language(EVAL CODE "cmake_language(DEFER CALL candela_precompile_now ${target} ${shared})")
endfunction()

function(candela_precompile_now target shared)
  get_target_property(own ${target} PRECOMPILE_HEADERS)
  if(NOT own AND NOT CMAKE_DISABLE_PRECOMPILE_HEADERS)
    target_precompile_headers(${target} REUSE_FROM ${shared})
  endif()
endfunction()

# candela_shared_headers(NAME HEADERS ... LIBRARIES ...): the target that compiles the precompiled header.
function(candela_shared_headers name)
  cmake_parse_arguments(ARG "" "" "HEADERS;LIBRARIES" ${ARGN})
  set(source ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT "// A precompiled header needs a target, and a target a source.\n")
  add_library(${name} OBJECT EXCLUDE_FROM_ALL ${source})
  target_link_libraries(${name} PRIVATE ${ARG_LIBRARIES})
  candela_compile_options(${name})
  target_precompile_headers(${name} PRIVATE ${ARG_HEADERS})
endfunction()
