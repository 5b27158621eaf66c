// Parses sweeps, and combines their values.
#include "host/app/cli/sweep.h"

#include <fmt/format.h>

#include <algorithm>

#include "host/app/cli/did_you_mean.h"
#include "host/app/cli/option_table.h"
#include "host/base/errors.h"

namespace candela::cli {
namespace {

struct Sweep {
  std::string name;
  const Option* option;
  std::vector<std::string> values;
};

// All variants share one renderer, so that the device cannot be swept.
bool canBeSwept(const Option& option) {
  const bool ofRenders = option.group == OptionGroup::image || option.group == OptionGroup::execution;
  return ofRenders && option.isFor(Command::bench) && !option.isFlag() && option.name() != "--device";
}

const Option& optionNamed(const std::string& name) {
  const Option* const found = findOption(Command::bench, "--" + name);
  if (found != nullptr && canBeSwept(*found)) return *found;
  std::vector<std::string> names;
  for (const Option& option : optionTable()) {
    if (canBeSwept(option)) names.push_back(option.name().substr(2));
  }
  throw UsageError(fmt::format("--sweep {}: not an option that can be swept{}", name, didYouMean(name, names)));
}

std::vector<std::string> split(const std::string& values) {
  std::vector<std::string> words(1);
  for (const char character : values) {
    if (character == ',') {
      words.emplace_back();
    } else {
      words.back() += character;
    }
  }
  return words;
}

Sweep parse(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) {
    throw UsageError(fmt::format("--sweep {}: expected an option and its values, as in workgroup=8x8,16x4", text));
  }
  const std::string name = text.substr(0, equals);
  return {name, &optionNamed(name), split(text.substr(equals + 1))};
}

void setOption(const Sweep& sweep, const std::string& value, BenchArguments& arguments) {
  Arguments command = arguments;
  if (!sweep.option->apply(command, value)) {
    throw UsageError(fmt::format("--sweep {}: expected {}, got \"{}\"", sweep.name, sweep.option->expected, value));
  }
  arguments = std::get<BenchArguments>(std::move(command));
  arguments.given.insert(sweep.option->name());
}

std::vector<SweptArguments> withEach(const std::vector<SweptArguments>& before, const Sweep& sweep) {
  std::vector<SweptArguments> all;
  for (const SweptArguments& one : before) {
    for (const std::string& value : sweep.values) {
      const std::string setting = sweep.name + "=" + value;
      all.push_back({one.name.empty() ? setting : one.name + " " + setting, one.arguments});
      setOption(sweep, value, all.back().arguments);
    }
  }
  return all;
}

}  // namespace

std::vector<SweptArguments> sweepOver(const BenchArguments& arguments) {
  std::vector<SweptArguments> all{{"", arguments}};
  std::vector<const Option*> swept;
  for (const std::string& text : arguments.sweeps) {
    const Sweep sweep = parse(text);
    if (std::find(swept.begin(), swept.end(), sweep.option) != swept.end()) {
      throw UsageError(fmt::format("--sweep {}: this option is swept twice", sweep.name));
    }
    swept.push_back(sweep.option);
    if (all.size() * sweep.values.size() > kMaxVariants) {
      throw UsageError(fmt::format("--sweep: more than {} combinations", kMaxVariants));
    }
    all = withEach(all, sweep);
  }
  if (arguments.sweeps.empty()) all.front().name = "as given";
  return all;
}

}  // namespace candela::cli
