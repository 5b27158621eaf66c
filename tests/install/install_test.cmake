# Installs BUILD into a separate folder under WORK, builds the consumer only against that, and renders a scene on the
# reference and on lavapipe (ICD). The two images must show the same scene, by `candela compare`.
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)
foreach(file share/doc/candela/copyright share/doc/candela/README.md share/candela/scenes/cornell.p3f share/candela/conformance/lavapipe-22.3.6-fails.txt)
  if(NOT EXISTS ${WORK}/prefix/${file})
    message(FATAL_ERROR "${file} was not installed")
  endif()
endforeach()
# The documentation and the consumer name the version that is installed.
file(STRINGS ${CMAKE_CURRENT_LIST_DIR}/../../docs/building.md documented REGEX "find_package\\(candela")
file(STRINGS ${CMAKE_CURRENT_LIST_DIR}/consumer/CMakeLists.txt used REGEX "find_package\\(candela")
string(STRIP "${documented}" documented)
if(NOT documented STREQUAL used)
  message(FATAL_ERROR "docs/building.md has \"${documented}\", and the consumer \"${used}\"")
endif()
run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/consumer -B ${WORK}/build -G Ninja -DCMAKE_PREFIX_PATH=${WORK}/prefix
    -DCMAKE_CXX_COMPILER=${COMPILER} "-DCMAKE_CXX_FLAGS=${FLAGS}")
run(${CMAKE_COMMAND} --build ${WORK}/build)
# Another minor version is refused.
file(WRITE ${WORK}/older/CMakeLists.txt "cmake_minimum_required(VERSION 3.25)\nproject(older LANGUAGES CXX)\nfind_package(candela 0.3 REQUIRED)\n")
execute_process(COMMAND ${CMAKE_COMMAND} -S ${WORK}/older -B ${WORK}/older/build -G Ninja -DCMAKE_PREFIX_PATH=${WORK}/prefix
                        -DCMAKE_CXX_COMPILER=${COMPILER} RESULT_VARIABLE accepted ERROR_VARIABLE message OUTPUT_QUIET)
if(accepted EQUAL 0 OR NOT message MATCHES "not.*compatible")
  message(FATAL_ERROR "a project that requires version 0.3 was not refused: ${message}")
endif()

set(ENV{VK_DRIVER_FILES} ${ICD})
set(ENV{VK_ICD_FILENAMES} ${ICD})
set(scene ${WORK}/prefix/share/candela/scenes/cornell.p3f)
run(${WORK}/build/consumer ${scene} cpu ${WORK}/cpu.exr ${WORK}/cpu.film.exr)
run(${WORK}/build/consumer ${scene} cpu ${WORK}/again.exr ${WORK}/cpu.film.exr)
run(${CMAKE_COMMAND} -E compare_files ${WORK}/cpu.exr ${WORK}/again.exr)
run(${WORK}/build/consumer ${scene} llvmpipe ${WORK}/device.exr ${WORK}/device.film.exr)
run(${WORK}/build/verdict llvmpipe)
run(${WORK}/prefix/bin/candela compare ${WORK}/cpu.exr ${WORK}/device.exr --tolerance 1e-4)
