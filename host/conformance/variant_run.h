// Compares two forms of the same kernel on one device, bit for bit.
#pragma once
#include "host/conformance/case.h"
#include "host/conformance/picture_run.h"
#include "host/variants/variant.h"

namespace candela::conformance {

/// Renders the picture with the plain form of its kernel and with the variant. Their films must be equal bit for bit.
Finding compareVariant(const Picture& picture, const variants::Variant& variant, Workbench& workbench);

}  // namespace candela::conformance
