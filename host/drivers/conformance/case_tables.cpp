// Joins the tables, and selects cases.
#include "host/drivers/conformance/case_tables.h"

#include <fnmatch.h>

#include <algorithm>
#include <iterator>

namespace candela::conformance {

Cases allCases(const PictureTest& test) {
  Cases all;
  for (Cases part : {pictureCases(test), integerCases(), floatCases(), functionCases(), controlCases(), memoryCases(),
                     groupCases()}) {
    std::ranges::move(part, std::back_inserter(all));
  }
  return all;
}

Cases casesNamed(const Cases& cases, const std::vector<std::string>& globs) {
  Cases chosen;
  for (const Case& one : cases) {
    const auto matches = [&](const std::string& glob) { return ::fnmatch(glob.c_str(), one.name.c_str(), 0) == 0; };
    if (std::ranges::any_of(globs, matches)) chosen.push_back(one);
  }
  return chosen;
}

}  // namespace candela::conformance
