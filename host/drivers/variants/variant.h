// Variants of a shader, which must compute the same.
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "host/drivers/variants/module.h"
#include "host/drivers/variants/mutation.h"
#include "host/trace/vulkan/shader_code.h"

namespace candela::variants {

enum class StepKind { pass, requestUnrolling, mutation };

/// A transformation of a module that preserves its results.
struct Step {
  StepKind kind = StepKind::pass;
  std::string pass{};   ///< of spirv-opt
  Mutation mutation{};  ///< of the project's own generator

  bool operator==(const Step&) const = default;
  /// Returns e.g. "spirv-opt --ccp" or "mutation 3 of seed 1".
  std::string text() const;
};

/// The way in which specialisation constants get their values.
enum class Constants {
  reduced,  ///< they are frozen, and unreachable code is removed, as in kernels in use:
            ///< host/trace/vulkan/reduced_spirv.h
  frozen,   ///< they are frozen
  open      ///< the driver sets them
};

struct Variant {
  std::string name;
  std::vector<Step> steps;  ///< in their order
  Constants constants = Constants::reduced;
  bool forbidsContraction = true;  ///< every floating-point operation is NoContraction
};

/// The form with which the others are compared: it has no steps.
Variant plainVariant();
/// Returns all others.
const std::vector<Variant>& allVariants();
/// Returns the variant without NoContraction, which a compiler may round in another way.
Variant withContraction(Variant variant);

/// Limits and observes preparation().
struct PreparationScope {
  /// Returns whether a module is to be transformed; empty: all are. The others get the plain form.
  std::function<bool(std::span<const std::uint32_t> spirv)> isMeant{};
  /// Is called with a description of each change that a step other than a pass made to a module; may be empty.
  std::function<void(std::span<const std::uint32_t> spirv, const std::string& text)> note{};
};

/// Returns a function that makes this variant of a module. It throws InternalError if the optimiser refuses a module.
vulkan::PrepareShader preparation(const Variant& variant, const PreparationScope& scope = {});

}  // namespace candela::variants
