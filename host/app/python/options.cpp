// Sets options by keyword arguments.
#include "host/app/python/options.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "host/app/cli/apply_options.h"
#include "host/app/cli/argument_checks.h"
#include "host/app/cli/did_you_mean.h"
#include "host/app/python/file_names.h"
#include "host/base/errors.h"
#include "host/base/json_text.h"

namespace candela::python {

namespace py = pybind11;
using cli::Command;
using cli::OptionGroup;

const FunctionOptions kLoadOptions{"load", Command::check, {OptionGroup::sceneFile}};
const FunctionOptions kSceneOptions{"Scene",
                                    Command::check,
                                    {OptionGroup::sceneFile},
                                    {},
                                    {"--camera", "--time", "--animation", "--orbit", "--define"}};
const FunctionOptions kRenderOptions{"render",
                                     Command::render,
                                     {OptionGroup::image, OptionGroup::execution, OptionGroup::film},
                                     {"--aov", "--denoise"},
                                     {"--memory"}};
const FunctionOptions kSessionOptions{"Session",
                                      Command::render,
                                      {OptionGroup::image, OptionGroup::execution},
                                      {"--crop", "--aov", "--denoise"},
                                      {"--memory", "--fallback", "--noise-threshold"}};
const FunctionOptions kSequenceOptions{
    "Sequence",
    Command::render,
    {OptionGroup::sceneFile, OptionGroup::sequence, OptionGroup::image, OptionGroup::execution},
    {"--crop", "--aov", "--denoise"},
    {"--memory"}};
const FunctionOptions kVerifyOptions{"verify",
                                     Command::verify,
                                     {OptionGroup::image, OptionGroup::execution, OptionGroup::verification},
                                     {"--alpha"},
                                     {"--memory", "--junit", "--explain", "--allow-undecided"}};
const FunctionOptions kExplainOptions{"explain",
                                      Command::explain,
                                      {OptionGroup::image, OptionGroup::execution, OptionGroup::explanation},
                                      {},
                                      {"--memory"}};
const FunctionOptions kCompareTracersOptions{
    "compare", Command::compare, {OptionGroup::image, OptionGroup::execution}, {"--alpha", "--bias"}, {"--memory"}};
const FunctionOptions kCompareImagesOptions{
    "compare", Command::compare, {}, {"--alpha", "--bias", "--tolerance", "--channels", "--tonemap", "--exposure"}};
const FunctionOptions kSaveOptions{
    "Film.save", Command::render, {}, {"--tonemap", "--exposure", "--denoise", "--device", "--no-cache"}};
const FunctionOptions kDenoiseOptions{
    "Film.denoise", Command::denoise, {}, {"--device", "--hang-timeout", "--no-cache"}};
const FunctionOptions kMergeOptions{"merge", Command::merge, {}, {"--mixed-devices", "--partial"}};

namespace {

// Python's name of the option for layers is a plural, because it takes several.
constexpr const char* kLayerOption = "--aov";
constexpr const char* kLayerKeyword = "aovs";

constexpr const char* kDefinitions = "--define";  // whose values are texts, one or several

// Returns whether a value is a floating-point number, of Python or NumPy, without a fraction.
bool isWholeFloat(const py::handle& value) {
  return PyIndex_Check(value.ptr()) == 0 && py::hasattr(value, "is_integer") && py::bool_(value.attr("is_integer")());
}

// Texts of any option may be names of files, as those of --env are. Options of whole numbers accept 4.0.
std::string wordOf(const py::handle& value) {
  if (isFileName(value)) return fileOf("", value).string();
  return isWholeFloat(value) ? py::str(py::int_(py::reinterpret_borrow<py::object>(value))) : py::str(value);
}

// NumPy's truth values are not those of Python.
bool isBoolean(const py::handle& value) {
  const std::string_view type = Py_TYPE(value.ptr())->tp_name;
  return py::isinstance<py::bool_>(value) || type == "numpy.bool_" || type == "numpy.bool";
}

bool isTrue(const py::handle& value) { return py::bool_(py::reinterpret_borrow<py::object>(value)); }

// Lists, tuples, arrays and others. An array without dimensions is a number.
bool isList(const py::handle& value) {
  if (isFileName(value) || PySequence_Check(value.ptr()) == 0) return false;
  const bool hasLength = PySequence_Size(value.ptr()) >= 0;
  if (!hasLength) PyErr_Clear();
  return hasLength;
}

bool isRange(const py::handle& value) { return PyObject_TypeCheck(value.ptr(), &PyRange_Type) != 0; }

// A range without samples, or with gaps, has no notation; the parser then reports the expected form.
std::string rangeText(const py::handle& range) {
  const std::string text = fmt::format("{}:{}", wordOf(range.attr("start")), wordOf(range.attr("stop")));
  const std::string step = wordOf(range.attr("step"));
  return step == "1" ? text : fmt::format("{}:{}", text, step);
}

std::string listText(const py::handle& list, const cli::Option& option) {
  const char* const separator = option.metavar.find('x') != std::string::npos ? "x" : ",";
  std::string text;
  for (const py::handle& item : list) text += (text.empty() ? "" : separator) + wordOf(item);
  return text;
}

std::string valueText(const py::handle& value, const cli::Option& option) {
  if (isBoolean(value)) return isTrue(value) ? "on" : "off";
  if (isRange(value)) return rangeText(value);
  return isList(value) ? listText(value, option) : wordOf(value);
}

std::string keywordOf(const cli::Option& option) {
  if (option.name() == kLayerOption) return kLayerKeyword;
  std::string keyword = option.name().substr(2);
  std::ranges::replace(keyword, '-', '_');
  return keyword;
}

void setFlag(const cli::Option& option, const py::handle& value, cli::Arguments& arguments) {
  if (option.name() == "--denoise" && py::isinstance<py::str>(value)) {
    return setOption(option, wordOf(value), arguments);
  }
  if (!isBoolean(value)) {
    throw UsageError(fmt::format("{}: expected True or False, got \"{}\"", keywordOf(option), wordOf(value)));
  }
  if (isTrue(value)) setOption(option, "true", arguments);
}

void set(const cli::Option& option, const py::handle& value, cli::Arguments& arguments) {
  if (option.isFlag()) return setFlag(option, value, arguments);
  if (option.name() == kLayerOption && isList(value) && py::len(value) == 0) return;
  const bool isPath = option.expected == "a path";
  if (!isPath && option.name() != kDefinitions) return setOption(option, valueText(value, option), arguments);
  const auto add = [&](const py::handle& item) {
    setOption(option, isPath ? fileOf(keywordOf(option), item).string() : wordOf(item), arguments);
  };
  if (!isList(value)) return add(value);
  for (const py::handle& item : value) add(item);
}

std::string nameOf(std::string keyword) {
  if (keyword == kLayerKeyword) return kLayerOption;
  std::ranges::replace(keyword, '_', '-');
  return "--" + keyword;
}

// The option of this name that the function has, or else one that it lacks; null if there is none.
const cli::Option* find(const FunctionOptions& function, const std::string& name) {
  const cli::Option* found = nullptr;
  for (const cli::Option& option : cli::optionTable()) {
    if (option.name() == name && (found == nullptr || function.has(option))) found = &option;
  }
  return found;
}

// Options of the program that the function lacks: most of them belong to another function.
[[noreturn]] void refuse(const FunctionOptions& function, const cli::Option& option) {
  const bool isOfLoad = kLoadOptions.has(option) && function.command != Command::check;
  throw UsageError(fmt::format("{} is not an option of candela.{}(){}", keywordOf(option), function.function,
                               isOfLoad ? "; candela.load() has it" : ""));
}

[[noreturn]] void refuseUnknown(const FunctionOptions& function, const std::string& keyword) {
  std::vector<std::string> known;
  for (const cli::Option& option : cli::optionTable()) {
    if (function.has(option)) known.push_back(keywordOf(option));
  }
  throw UsageError(fmt::format("unknown option {}{}", keyword, cli::didYouMean(keyword, known)));
}

}  // namespace

bool FunctionOptions::has(const cli::Option& option) const {
  if (!option.isFor(command) || except.contains(option.name())) return false;
  return groups.contains(option.group) || besides.contains(option.name());
}

cli::Arguments anyArgumentsOf(const FunctionOptions& function, const py::kwargs& options) {
  cli::Arguments arguments = cli::defaultArguments(function.command);
  for (const auto& [name, value] : options) {
    const std::string keyword = py::str(name);
    const cli::Option* const option = find(function, nameOf(keyword));
    if (option == nullptr) refuseUnknown(function, keyword);
    if (!function.has(*option)) refuse(function, *option);
    if (!value.is_none()) set(*option, value, arguments);
  }
  checkOptions(arguments);
  return arguments;
}

std::string keywordWords(std::string_view name, std::string_view value) {
  if (name == "output") return "an image";  // files of images have no keyword
  const std::string option = "--" + std::string(name);
  const auto found = std::ranges::find(cli::optionTable(), option, &cli::Option::name);
  if (found == cli::optionTable().end()) return std::string(name);
  const std::string keyword = keywordOf(*found);
  if (value.empty()) return keyword;
  if (found->isFlag()) return keyword + "=True";
  const bool isNumber = value.find_first_not_of("0123456789.") == std::string_view::npos;
  // A literal of JSON is one of Python.
  return fmt::format("{}={}", keyword, isNumber ? std::string(value) : jsonText(nlohmann::json(value)));
}

std::string helpOf(const FunctionOptions& function) {
  std::string text;
  for (const cli::Option& option : cli::optionTable()) {
    if (!function.has(option)) continue;
    text += fmt::format("  {}: {}", keywordOf(option), option.help);
    text += option.defaultText.empty() ? "\n" : fmt::format(" (default: {})\n", option.defaultText);
  }
  return text;
}

}  // namespace candela::python
