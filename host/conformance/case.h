// A case of the conformance run: a question about a device, with its answer.
#pragma once
#include <functional>
#include <string>
#include <vector>

namespace candela::conformance {

class Workbench;

/// The finding of a case itself. The runner notices crashes and hangs.
enum class Outcome { pass, fail, skip };

struct Finding {
  Outcome outcome = Outcome::pass;
  std::string text;  ///< of a failure: what differs; of a skipped case: the missing feature
};

Finding passed();
Finding failed(std::string text);
Finding skipped(std::string missingFeature);

struct Case {
  std::string name;   ///< parts of letters, digits and underscores, separated by dots
  std::string group;  ///< cases of one group may run in one child process, because they share kernels or images
  std::function<Finding(Workbench&)> run;
};

using Cases = std::vector<Case>;

}  // namespace candela::conformance
