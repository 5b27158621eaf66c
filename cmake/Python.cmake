# The Python module is built where pybind11 is found: CANDELA_BUILDS_PYTHON is true then.
set(CANDELA_PYTHON_MODULE AUTO CACHE STRING "Build the Python module: ON, OFF, or AUTO for where pybind11 is installed")
set_property(CACHE CANDELA_PYTHON_MODULE PROPERTY STRINGS AUTO ON OFF)

# A module with sanitizers could only be loaded into a Python that has them, too.
set(CANDELA_BUILDS_PYTHON OFF)
if(CANDELA_PYTHON_MODULE AND NOT CANDELA_SANITIZE AND NOT CANDELA_FUZZ)
  # The system's Python is the one for which the packages of pybind11 and NumPy are, whatever comes first in PATH.
  if(NOT DEFINED Python_EXECUTABLE AND EXISTS /usr/bin/python3)
    set(Python_EXECUTABLE /usr/bin/python3 CACHE FILEPATH "The Python for which the module is built")
  endif()
  if(CANDELA_PYTHON_MODULE STREQUAL AUTO)
    find_package(Python 3.9 QUIET COMPONENTS Interpreter Development.Module)
  else()
    find_package(Python 3.9 REQUIRED COMPONENTS Interpreter Development.Module)
    set(required REQUIRED)
  endif()
  if(Python_FOUND)
    find_package(pybind11 2.10 QUIET ${required} CONFIG)
    set(CANDELA_BUILDS_PYTHON ${pybind11_FOUND})
  endif()
endif()

# candela_for_python(TARGET): lets the module, which is a shared library, link this static one. Hidden symbols keep calls
# within the code direct, as in the program.
function(candela_for_python target)
  if(CANDELA_BUILDS_PYTHON)
    set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  endif()
endfunction()
