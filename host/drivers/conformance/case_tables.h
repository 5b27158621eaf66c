// The tables from which the cases are made.
#pragma once
#include "host/drivers/conformance/case.h"
#include "host/drivers/conformance/picture_test.h"

namespace candela::conformance {

/// Integer functions of GLSL and the samplers, bit for bit.
Cases integerCases();
/// Arithmetic, roots, conversions and built-in functions of GLSL, to the errors that Vulkan allows.
Cases floatCases();
/// Candela's own functions: the exact sums of films, elementary functions and warps, within the errors that their
/// documentation states.
Cases functionCases();
/// Loops, breaks, switches, stacks.
Cases controlCases();
/// Buffers, atomic operations, barriers, queues, robust access.
Cases memoryCases();
/// Subgroups and workgroups.
Cases groupCases();
/// Whole pictures by each kernel, compared with the reference.
Cases pictureCases(const PictureTest& test);

/// Returns all of the above.
Cases allCases(const PictureTest& test = {});

/// Kernels, compared with variants of them that must compute the same: `candela conformance --variants`.
Cases variantCases();

/// Returns the cases of `cases` whose name matches any of `globs`, patterns with *, ? and [...] as in a shell.
Cases casesNamed(const Cases& cases, const std::vector<std::string>& globs);

}  // namespace candela::conformance
