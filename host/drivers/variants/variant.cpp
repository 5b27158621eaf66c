// Makes variants of modules.
#include "host/drivers/variants/variant.h"

#include <fmt/format.h>

#include <optional>

#include "host/drivers/variants/no_contraction.h"
#include "host/drivers/variants/passes.h"
#include "host/drivers/variants/unroll_control.h"
#include "host/trace/vulkan/reduced_spirv.h"

namespace candela::variants {
namespace {

using Specialisations = std::vector<vulkan::Specialisation>;
using Note = std::function<void(const std::string&)>;

// Applies steps to a module. Mutations that follow each other choose among the instructions of the same module.
class Workshop {
 public:
  Workshop(Code code, Note note) : code_(std::move(code)), note_(std::move(note)) {}

  void apply(const Step& step) {
    if (step.kind == StepKind::pass) {
      finishMutations();
      pending_.push_back(step.pass);
    } else {
      finishPasses();
      step.kind == StepKind::mutation ? mutate(step) : unroll(step);
    }
  }

  Code take() {
    finishMutations();
    finishPasses();
    return std::move(code_);
  }

 private:
  void mutate(const Step& step) {
    if (!module_) {
      module_ = parseModule(code_);
      mutator_.emplace(*module_);
    }
    if (const std::string done = mutator_->apply(step.mutation); !done.empty()) note_(step.text() + ": " + done);
  }

  void unroll(const Step& step) {
    finishMutations();
    Module module = parseModule(code_);
    if (const std::size_t loops = requestUnrolling(module); loops > 0)
      note_(fmt::format("{} of {} loops", step.text(), loops));
    code_ = codeOf(module);
  }

  void finishMutations() {
    if (!module_) return;
    code_ = codeOf(*module_);
    mutator_.reset();
    module_.reset();
  }

  void finishPasses() {
    if (pending_.empty()) return;
    code_ = optimised(code_, pending_);
    pending_.clear();
  }

  Code code_;
  Note note_;
  std::vector<std::string> pending_;  ///< passes that have not run
  std::optional<Module> module_;      ///< while mutations follow each other
  std::optional<Mutator> mutator_;
};

Code withConstants(Constants constants, std::span<const std::uint32_t> spirv, const Specialisations& values) {
  if (constants == Constants::reduced) return vulkan::reducedSpirv(spirv, values);
  if (constants == Constants::frozen) return vulkan::frozenSpirv(spirv, values);
  return {spirv.begin(), spirv.end()};
}

Code forbidden(const Code& code) {
  Module module = parseModule(code);
  forbidContraction(module);
  return codeOf(module);
}

vulkan::ShaderCode prepare(const Variant& variant, std::span<const std::uint32_t> spirv, const Specialisations& values,
                           const Note& note) {
  Code code = withConstants(variant.constants, spirv, values);
  if (variant.forbidsContraction) code = forbidden(code);
  Workshop workshop(std::move(code), note);
  for (const Step& step : variant.steps) workshop.apply(step);
  return {workshop.take(), variant.constants == Constants::open ? values : Specialisations{}};
}

Variant plainFormOf(const Variant& variant) {
  Variant plain = plainVariant();
  plain.forbidsContraction = variant.forbidsContraction;
  return plain;
}

}  // namespace

std::string Step::text() const {
  if (kind == StepKind::pass) return "spirv-opt --" + pass;
  if (kind == StepKind::requestUnrolling) return "loop control Unroll";
  return fmt::format("mutation {} of seed {}", mutation.index, mutation.seed);
}

vulkan::PrepareShader preparation(const Variant& variant, const PreparationScope& scope) {
  return [variant, scope](std::span<const std::uint32_t> spirv, const Specialisations& values) {
    const bool isMeant = !scope.isMeant || scope.isMeant(spirv);
    const Note note = [&](const std::string& text) {
      if (scope.note) scope.note(spirv, text);
    };
    return prepare(isMeant ? variant : plainFormOf(variant), spirv, values, note);
  };
}

}  // namespace candela::variants
