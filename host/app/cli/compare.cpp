// `candela compare`: compares two images, two sets of renders, or two tracers.
#include <algorithm>

#include "host/app/cli/commands.h"
#include "host/app/cli/comparison.h"
#include "host/app/cli/file_kinds.h"
#include "host/image/image.h"

namespace candela::cli {
namespace {

void requireImagesOrScene(const CompareArguments& arguments) {
  const std::vector<std::string>& files = arguments.files;
  if (!arguments.others.empty()) return;
  const auto scene = std::ranges::find_if(files, [](const std::string& file) { return isSceneName(file); });
  if (files.size() == 2 && scene != files.end()) {
    throw UsageError("compare takes two images or one scene, and " + *scene + " is a scene");
  }
  if (files.size() == 1 && image::hasImageExtension(files.front())) {
    throw UsageError("compare " + files.front() + ": the second image is missing");
  }
}

}  // namespace

ExitCode run(const CompareArguments& arguments, const Log& log) {
  requireImagesOrScene(arguments);
  if (!arguments.others.empty()) return compareRenderSets(arguments, log);
  return arguments.files.size() == 2 ? compareImageFiles(arguments, log) : compareTracersOnScene(arguments, log);
}

}  // namespace candela::cli
