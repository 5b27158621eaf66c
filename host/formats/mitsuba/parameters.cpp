// Replaces parameters by their values.
#include "host/formats/mitsuba/parameters.h"

#include <fmt/format.h>

#include "host/base/errors.h"
#include "host/base/quote.h"
#include "host/base/setting_words.h"
#include "host/formats/mitsuba/names.h"

namespace candela::mitsuba {
namespace {

constexpr std::size_t kMaxValueBytes = std::size_t{64} << 20;
constexpr std::size_t kMaxParameterName = 256;

bool isPartOfName(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

std::string_view nameAt(std::string_view text, std::size_t begin) {
  std::size_t end = begin;
  while (end < text.size() && end - begin < kMaxParameterName && isPartOfName(text[end])) ++end;
  return text.substr(begin, end - begin);
}

}  // namespace

Parameters::Parameters(const std::vector<std::string>& definitions) {
  for (const std::string& definition : definitions) {
    const std::size_t equals = definition.find('=');
    const std::string name = definition.substr(0, equals);
    if (equals == std::string::npos || name.empty() || nameAt(name, 0) != name) {
      throw UsageError(fmt::format("{}: a definition is NAME=VALUE, with a name of letters, digits and _",
                                   settingWords("define", definition)));
    }
    parameters_[name] = {definition.substr(equals + 1), false, true};
  }
}

void Parameters::addDefault(const std::string& name, const std::string& value) {
  if (name.size() <= kMaxParameterName) parameters_.emplace(name, Parameter{value});
}

std::string Parameters::substitute(const std::string& text, const Place& place) {
  if (text.find('$') == std::string::npos) return text;
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\\' && i + 1 < text.size() && text[i + 1] == '$') {
      result += text[++i];
      continue;
    }
    if (text[i] != '$') {
      result += text[i];
      continue;
    }
    const std::string_view whole = nameAt(text, i + 1);
    std::string_view name = whole;
    auto found = parameters_.find(name);
    while (found == parameters_.end() && !name.empty()) {
      name.remove_suffix(1);
      found = parameters_.find(name);
    }
    if (found == parameters_.end()) {
      std::vector<std::string_view> names;
      for (const auto& [known, parameter] : parameters_) names.push_back(known);
      throw PlacedError{
          place, fmt::format("the parameter {} has no value: neither <default> nor {} defines it{}",
                             scene::quote(whole), settingWords("define", "NAME=VALUE"), suggestionFor(whole, names))};
    }
    found->second.isUsed = true;
    result += found->second.value;
    i += name.size();
    if (byteCount_ + result.size() > kMaxValueBytes) {
      throw PlacedError{place, fmt::format("values with parameters take more than {} MiB", kMaxValueBytes >> 20)};
    }
  }
  byteCount_ += result.size();
  return result;
}

std::vector<std::string> Parameters::unusedDefinitions() const {
  std::vector<std::string> names;
  for (const auto& [name, parameter] : parameters_) {
    if (parameter.isDefinition && !parameter.isUsed) names.push_back(name);
  }
  return names;
}

}  // namespace candela::mitsuba
