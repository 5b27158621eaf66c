// verify(), compare() and explain().
#pragma once
#include <pybind11/pybind11.h>

#include <optional>
#include <string>

namespace candela::python {

/// The result of a command that compares: its printed text, its JSON report, and whether the sides agree, which
/// is empty for two images without a criterion and for a verdict that is not decided.
struct Outcome {
  std::optional<bool> agrees;
  std::string verdict;  ///< sentences
  std::string text;
  std::string report;        ///< JSON
  bool isUndecided = false;  ///< there is a verdict, which is not decided
};
struct Verdict : Outcome {};
struct Comparison : Outcome {};
struct Explanation : Outcome {};

void defineVerdicts(pybind11::module_& module);

}  // namespace candela::python
