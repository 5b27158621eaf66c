// Observes variants in child processes.
#include "host/drivers/conformance/variant_shrink.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "host/base/errors.h"
#include "host/base/stopwatch.h"
#include "host/drivers/capture/subset.h"
#include "host/drivers/child_process.h"

namespace candela::conformance {
namespace {

using capture::Subset;
using variants::Variant;
using Names = std::vector<std::string>;

/// The result of a child process.
struct Trial {
  std::string key;  ///< of the observation, or kLost
  Names modules;    ///< that the form has, in the order of their pipelines
  Names notes;      ///< the changes that each step made to each module
};

constexpr const char* kLost = "does not terminate normally";

void addOnce(Names& names, const std::string& name) {
  if (std::ranges::find(names, name) == names.end()) names.push_back(name);
}

class Shrinker {
 public:
  Shrinker(const VariantQuestion& question, const vulkan::DeviceInfo& device, const ShrinkLimits& limits)
      : question_(question), device_(device), limits_(limits) {}

  std::string run() {
    const Trial plain = observe(plainFormOf(question_), {});
    const Trial whole = observe(question_.variant, plain.modules);
    plainKey_ = plain.key;
    if (whole.key == plainKey_) return "the difference did not recur in a second run";
    Variant form = question_.variant;
    form.steps = stepsLeft(plain.modules);
    const Names modules = modulesLeft(form, plain.modules);
    return textOf(form, modules, plain.modules.size(), observe(form, modules).notes);
  }

 private:
  // Returns the steps that remain when none can be removed, in all modules.
  std::vector<variants::Step> stepsLeft(const Names& modules) {
    const std::vector<variants::Step>& all = question_.variant.steps;
    if (all.empty()) return {};
    const auto chosen = [&](const Subset& kept) {
      std::vector<variants::Step> steps;
      for (const std::size_t index : kept) steps.push_back(all[index]);
      return steps;
    };
    return chosen(capture::smallestSubset(
        all.size(), [&](const Subset& kept) { return differs(chosen(kept), modules); }, [&] { return isOver(); }));
  }

  Names modulesLeft(const Variant& form, const Names& modules) {
    const auto chosen = [&](const Subset& kept) {
      Names names;
      for (const std::size_t index : kept) names.push_back(modules[index]);
      return names;
    };
    if (modules.size() < 2) return modules;
    return chosen(capture::smallestSubset(
        modules.size(), [&](const Subset& kept) { return differs(form.steps, chosen(kept)); },
        [&] { return isOver(); }));
  }

  bool differs(const std::vector<variants::Step>& steps, const Names& modules) {
    ++trials_;
    Variant form = question_.variant;
    form.steps = steps;
    return observe(form, modules).key != plainKey_;
  }

  // Transforms only these modules.
  Trial observe(const Variant& form, const Names& modules) const {
    const process::ChildResult result = process::runInChild(
        limits_.trial,
        [&] {
          Names seen, notes;
          variants::PreparationScope scope;
          scope.isMeant = [&](std::span<const std::uint32_t> spirv) {
            addOnce(seen, moduleName(spirv));
            return std::ranges::find(modules, moduleName(spirv)) != modules.end();
          };
          scope.note = [&](std::span<const std::uint32_t> spirv, const std::string& text) {
            addOnce(notes, moduleName(spirv) + ": " + text);
          };
          const std::string key = observeForm(question_, form, device_, scope).key;
          return nlohmann::json{{"key", key}, {"modules", seen}, {"notes", notes}};
        },
        limits_.stop);
    if (result.interrupted) throw InterruptedError("interrupted while a difference was shrunk");
    if (!result.failure.empty()) return {kLost, {}, {}};
    return {result.answer.at("key"), result.answer.at("modules"), result.answer.at("notes")};
  }

  bool isOver() {
    passed_ += watch_.lap();
    return passed_ > limits_.seconds;
  }

  std::string textOf(const Variant& form, const Names& modules, std::size_t moduleCount, const Names& notes) {
    std::string text = fmt::format("smallest difference, after {} trials{}: ", trials_,
                                   isOver() ? ", when the time was over" : "");
    if (!question_.variant.steps.empty()) {
      text += fmt::format("{} of {} steps, ", form.steps.size(), question_.variant.steps.size());
    }
    text += fmt::format("in {} of {} modules: {}", modules.size(), moduleCount, fmt::join(modules, ", "));
    for (const variants::Step& step : form.steps) {
      if (step.kind == variants::StepKind::pass) text += "\n" + step.text();
    }
    for (const std::string& note : notes) text += "\n" + note;
    return text;
  }

  const VariantQuestion& question_;
  const vulkan::DeviceInfo& device_;
  const ShrinkLimits& limits_;
  std::string plainKey_;
  std::size_t trials_ = 0;
  Stopwatch watch_;
  double passed_ = 0;
};

}  // namespace

std::string smallestDifference(const VariantQuestion& question, const vulkan::DeviceInfo& device,
                               const ShrinkLimits& limits) {
  return Shrinker(question, device, limits).run();
}

}  // namespace candela::conformance
