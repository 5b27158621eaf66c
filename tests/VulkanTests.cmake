# candela_vulkan_test(NAME SOURCES ... LIBRARIES ...): like candela_test, but each case is registered once for every
# software Vulkan driver below, with the validation layer on; any message of the layer fails the case. A driver that is
# not installed is a failing test, never a skipped one. When cross-compiling, there are none. By hand, on another device:
#   CANDELA_VALIDATION=1 CANDELA_TEST_DEVICE=nvidia build/dev/tests/trace/vulkan/test_vulkan

# candela_driver_environment(VARIABLE ICD): sets VARIABLE to the environment of tests in which one driver is visible.
# VK_ICD_FILENAMES is what loaders before 1.3.207 read. Drivers and the layer leak a few kilobytes when they are
# unloaded, in modules that the leak sanitizer can then no longer name to suppress them; its other checks stay on.
function(candela_driver_environment variable icd)
  set(${variable} "VK_DRIVER_FILES=${icd};VK_ICD_FILENAMES=${icd};ASAN_OPTIONS=detect_leaks=0" PARENT_SCOPE)
endfunction()

# Sets VARIABLE to the first file that matches, unless the user has set it to one that exists.
function(candela_find_icd variable)
  if(EXISTS "${${variable}}")
    return()
  endif()
  file(GLOB icds ${ARGN})
  list(APPEND icds "${variable}-NOTFOUND")
  list(GET icds 0 icd)
  set(${variable} ${icd} PARENT_SCOPE)
endfunction()

candela_find_icd(CANDELA_LAVAPIPE_ICD
  /usr/share/vulkan/icd.d/lvp_icd*.json /usr/local/share/vulkan/icd.d/lvp_icd*.json /etc/vulkan/icd.d/lvp_icd*.json)
candela_find_icd(CANDELA_SWIFTSHADER_ICD
  /usr/lib/chromium*/vk_swiftshader_icd.json /opt/google/chrome*/vk_swiftshader_icd.json
  /usr/share/vulkan/icd.d/vk_swiftshader_icd.json /usr/local/share/vulkan/icd.d/vk_swiftshader_icd.json)

add_library(candela_vulkan_test_support OBJECT trace/vulkan_support/test_device.cpp trace/vulkan_support/validation_listener.cpp)
target_link_libraries(candela_vulkan_test_support PUBLIC candela_vulkan candela_test_main)
candela_compile_options(candela_vulkan_test_support)

function(candela_vulkan_test name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LIBRARIES" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE candela_vulkan_test_support ${ARG_LIBRARIES})
  candela_compile_options(${name})
  if(CMAKE_CROSSCOMPILING)
    set_target_properties(${name} PROPERTIES EXCLUDE_FROM_ALL ON)
    return()  # an emulated driver takes minutes for a picture; tests/drivers/emulated has what is tested
  endif()
  candela_discover_on_driver(${name} lavapipe "${CANDELA_LAVAPIPE_ICD}" mesa-vulkan-drivers "[slow]")
  candela_discover_on_driver(${name} swiftshader "${CANDELA_SWIFTSHADER_ICD}" chromium-common "[slow],[swiftshader-slow]")
endfunction()

# `slow`: the cases that carry the label `slow` on this driver. SwiftShader takes five seconds to compile a path tracer
# with many features, and computes slowly, so that cases which need many kernels or samples are slow there, and only there.
function(candela_discover_on_driver name driver icd package slow)
  if(NOT EXISTS "${icd}")
    add_test(NAME "${driver}: ${name}" COMMAND sh -c "echo '${driver} is not installed: apt-get install ${package}, then configure again'; exit 1")
    return()
  endif()
  # OUTPUT_SUFFIX only distinguishes the files of two discoveries of one program; no file is written under that name.
  string(REGEX REPLACE ",?\\[" "~[" fast "${slow}")
  catch_discover_tests(${name} TEST_SPEC "${fast}" TEST_PREFIX "${driver}: ${name}: " OUTPUT_SUFFIX ${driver}
                       EXTRA_ARGS ${fail_without_cases} TEST_LIST ${name}_${driver})
  catch_discover_tests(${name} TEST_SPEC "${slow}" TEST_PREFIX "${driver}: ${name}: " OUTPUT_SUFFIX ${driver}
                       EXTRA_ARGS ${fail_without_cases} TEST_LIST ${name}_${driver}_slow PROPERTIES LABELS slow)
  # A list of variables does not pass through catch_discover_tests; it is set when ctest reads the discovered tests.
  candela_driver_environment(environment "${icd}")
  list(PREPEND environment CANDELA_VALIDATION=1)
  set(script ${CMAKE_CURRENT_BINARY_DIR}/${name}_${driver}_environment.cmake)
  file(WRITE ${script}
    "foreach(test IN LISTS ${name}_${driver} ${name}_${driver}_slow)\n"
    "  set_tests_properties(\"\${test}\" PROPERTIES ENVIRONMENT \"${environment}\")\n"
    "endforeach()\n")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${script})
endfunction()
