// Makes findings.
#include "host/drivers/conformance/case.h"

#include <utility>

namespace candela::conformance {

Finding passed() { return {}; }
Finding failed(std::string text) { return {Outcome::fail, std::move(text)}; }
Finding skipped(std::string missingFeature) { return {Outcome::skip, std::move(missingFeature)}; }

Finding perInvocation(Finding finding) {
  finding.isPerInvocation = true;
  return finding;
}

}  // namespace candela::conformance
