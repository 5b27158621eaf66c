// Forms of a shader that must compute the same.
#pragma once
#include <string>
#include <vector>

#include "host/variants/module.h"
#include "host/vulkan/shader_code.h"

namespace candela::variants {

/// A transformation of a module that keeps what it computes.
struct Step {
  std::string pass;  ///< of spirv-opt
  bool operator==(const Step&) const = default;
};

struct Variant {
  std::string name;
  std::vector<Step> steps;
  bool forbidsContraction = true;  ///< every floating-point operation is NoContraction
};

/// The form that the others are compared with: without steps.
Variant plainVariant();
/// Returns all others.
std::vector<Variant> allVariants();

/// Returns a function that makes this form of a module.
vulkan::PrepareShader preparation(const Variant& variant);

}  // namespace candela::variants
