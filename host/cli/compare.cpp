// `candela compare`: compares two images, or two tracers.
#include "host/cli/commands.h"
#include "host/cli/comparison.h"

namespace candela::cli {

ExitCode runCompare(const Arguments& arguments, const Log& log) {
  return arguments.files.size() == 2 ? compareImageFiles(arguments, log) : compareTracersOnScene(arguments, log);
}

}  // namespace candela::cli
