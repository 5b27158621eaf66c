// Turns errors into Python's exceptions.
#pragma once
#include <pybind11/pybind11.h>

namespace candela::python {

/// From this call on, every Error that leaves a function of the module raises the exception of candela._errors that has
/// its exit code, with the same text.
void translateErrors();

}  // namespace candela::python
