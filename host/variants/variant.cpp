// The table of variants, and how they are made.
#include "host/variants/variant.h"

#include "host/variants/no_contraction.h"
#include "host/variants/passes.h"
#include "host/vulkan/reduced_spirv.h"

namespace candela::variants {
namespace {

std::vector<Step> stepsOf(const std::vector<std::string>& passes) {
  std::vector<Step> steps;
  for (const std::string& pass : passes) steps.push_back({pass});
  return steps;
}

std::vector<std::string> passesOf(const std::vector<Step>& steps) {
  std::vector<std::string> passes;
  for (const Step& step : steps) passes.push_back(step.pass);
  return passes;
}

vulkan::ShaderCode prepare(const Variant& variant, std::span<const std::uint32_t> spirv,
                           const std::vector<vulkan::Specialisation>& specialisations) {
  Code code = vulkan::reducedSpirv(spirv, specialisations);
  if (variant.forbidsContraction) {
    Module module = parseModule(code);
    forbidContraction(module);
    code = codeOf(module);
  }
  return {optimised(code, passesOf(variant.steps))};
}

}  // namespace

Variant plainVariant() { return {"plain", {}}; }

std::vector<Variant> allVariants() { return {{"O", stepsOf(performancePasses())}, {"Os", stepsOf(sizePasses())}}; }

vulkan::PrepareShader preparation(const Variant& variant) {
  return [variant](std::span<const std::uint32_t> spirv, const std::vector<vulkan::Specialisation>& specialisations) {
    return prepare(variant, spirv, specialisations);
  };
}

}  // namespace candela::variants
