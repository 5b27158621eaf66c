# The project's warnings and sanitizers.
if(CANDELA_SANITIZE STREQUAL thread)
  set(CANDELA_SANITIZE_FLAGS -fsanitize=thread)
elseif(CANDELA_SANITIZE STREQUAL address)
  set(CANDELA_SANITIZE_FLAGS -fsanitize=address,undefined)
elseif(CANDELA_SANITIZE)
  message(FATAL_ERROR "CANDELA_SANITIZE is '${CANDELA_SANITIZE}', but must be OFF, address or thread")
endif()

function(candela_compile_options target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wnon-virtual-dtor
                                           -Woverloaded-virtual -Wnull-dereference)
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    # GCC 12 to 14 report overlaps and overruns within std::string and std::vector that cannot occur (its bug 105651).
    target_compile_options(${target} PRIVATE -Wno-restrict -Wno-array-bounds -Wno-stringop-overflow)
  else()
    # With Clang, -Wconversion has this too; GCC has it in C only.
    target_compile_options(${target} PRIVATE -Wno-sign-conversion)
  endif()
  # The reference must be computed as written: no contraction into fma, no reassociation.
  target_compile_options(${target} PRIVATE -ffp-contract=off)
  if(CANDELA_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(CANDELA_FUZZ)
    target_compile_options(${target} PUBLIC -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
    target_link_options(${target} PUBLIC -fsanitize=address,undefined)
  endif()
  if(CANDELA_SANITIZE)
    if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
      # GCC 12 loses track of std::function within std::regex once it is instrumented.
      target_compile_options(${target} PRIVATE -Wno-maybe-uninitialized)
    endif()
    target_compile_options(${target} PUBLIC ${CANDELA_SANITIZE_FLAGS} -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
    target_link_options(${target} PUBLIC ${CANDELA_SANITIZE_FLAGS})
  endif()
endfunction()

# candela_library(NAME SOURCES...): a static library with these options, installed where CANDELA_EXPORT is on.
function(candela_library name)
  add_library(${name} STATIC ${ARGN})
  target_link_libraries(${name} PUBLIC glm::glm fmt::fmt Threads::Threads)
  target_compile_features(${name} PUBLIC cxx_std_20)
  target_include_directories(${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:include/candela>)
  if(CANDELA_EXPORT)
    set_property(GLOBAL APPEND PROPERTY CANDELA_EXPORTED ${name})
  endif()
  candela_compile_options(${name})
  candela_for_python(${name})
  # One batch of a unity build for all files of most libraries, so that it reads the headers of other libraries once.
  set_target_properties(${name} PROPERTIES UNITY_BUILD_BATCH_SIZE 50)
  candela_precompile(${name} candela_library_headers)
endfunction()

# candela_quick_to_build(NAME): for a library whose speed hardly matters; with -O1 it compiles in two thirds of the time of -O3.
function(candela_quick_to_build name)
  target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()
