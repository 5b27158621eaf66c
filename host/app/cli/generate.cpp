// `candela generate`: writes a procedural scene to a file or to stdout.
#include <fmt/format.h>

#include "host/app/cli/commands.h"
#include "host/app/cli/did_you_mean.h"
#include "host/app/cli/file_kinds.h"
#include "host/app/cli/notation.h"
#include "host/app/cli/scene_output.h"
#include "host/scene/generate/kinds.h"

namespace candela::cli {
namespace {

using generate::Kind;

// Throws UsageError if the name of the file is that of another format.
void requireFormat(const Kind& kind, const std::string& file) {
  if (kind.isGltf) {
    refuseOtherFormat(file, {".gltf"}, fmt::format("{} is written as glTF in JSON", kind.name));
  } else {
    refuseOtherFormat(file, {".nff", ".p3f"}, fmt::format("{} is written as NFF", kind.name));
  }
}

[[noreturn]] void fail(const std::string& message) { throw UsageError(message + "\nsee candela generate --help"); }

const Kind& kindNamed(const std::string& name) {
  std::vector<std::string> names;
  for (const Kind& kind : generate::kindTable()) {
    if (kind.name == name) return kind;
    names.emplace_back(kind.name);
  }
  const std::string meant = didYouMean(name, names);
  fail(fmt::format("unknown kind {}{}", name, meant.empty() ? "; expected " + joinAlternatives(names) : meant));
}

std::uint32_t sizeFor(const Kind& kind, const GenerateArguments& arguments) {
  const std::uint32_t size = arguments.size.value_or(kind.defaultSize);
  const std::uint32_t largest = kind.maxSize();
  if (size >= kind.minSize && size <= largest) return size;
  const std::string reason = kind.maxInstances > 0 ? ""
                                                   : fmt::format("; larger scenes have more than {} primitives",
                                                                 generate::kMaxPrimitives);
  fail(fmt::format("--size: expected a whole number from {} to {} for {}, got {}{}", kind.minSize, largest, kind.name,
                   size, reason));
}

}  // namespace

ExitCode run(const GenerateArguments& arguments, const Log& log) {
  const Kind& kind = kindNamed(arguments.files.front());
  const std::uint32_t size = sizeFor(kind, arguments);
  requireFormat(kind, arguments.generatedFile);
  writeSceneText(arguments.generatedFile, [&](const auto& sink) { generateScene(kind, size, sink); });
  log.note(fmt::format("{} of size {}: {} primitives", kind.name, size, kind.primitiveCount(size)));
  return ExitCode::done;
}

}  // namespace candela::cli
