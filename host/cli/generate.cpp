// `candela generate`: a procedural scene to a file or to stdout.
#include <fmt/format.h>

#include <atomic>
#include <iostream>

#include "host/cli/commands.h"
#include "host/cli/did_you_mean.h"
#include "host/cli/notation.h"
#include "host/cli/output_check.h"
#include "host/core/atomic_file.h"
#include "host/core/interrupt.h"
#include "host/generate/kinds.h"

namespace candela::cli {
namespace {

using generate::Kind;

[[noreturn]] void fail(const std::string& message) { throw UsageError(message + "\nsee candela generate --help"); }

const Kind& kindNamed(const std::string& name) {
  std::vector<std::string> names;
  for (const Kind& kind : generate::kindTable()) {
    if (kind.name == name) return kind;
    names.emplace_back(kind.name);
  }
  const std::string meant = didYouMean(name, names);
  fail(fmt::format("unknown kind {}{}", name, meant.empty() ? "; there are " + joinAlternatives(names) : meant));
}

std::uint32_t sizeFor(const Kind& kind, const Arguments& arguments) {
  const std::uint32_t size = arguments.generatedSize.value_or(kind.defaultSize);
  const std::uint32_t largest = kind.largestSize();
  if (size >= kind.smallestSize && size <= largest) return size;
  fail(fmt::format(
      "--size: expected a whole number from {} to {} for {}, got {}; larger scenes have more than {} primitives",
      kind.smallestSize, largest, kind.name, size, generate::kMostPrimitives));
}

/// Passes blocks on until Ctrl-C. Half a scene is worth nothing, and no file appears.
generate::NffWriter::Sink interruptible(generate::NffWriter::Sink sink) {
  const std::atomic<bool>& interrupted = watchInterrupts();
  return [&interrupted, sink = std::move(sink)](std::string_view block) {
    if (interrupted) throw InterruptedError("interrupted before the scene was complete");
    sink(block);
  };
}

void writeToStdout(std::string_view block) {
  if (!std::cout.write(block.data(), static_cast<std::streamsize>(block.size()))) {
    throw FileError("cannot write to stdout");
  }
}

void writeScene(const Kind& kind, std::uint32_t size, const std::string& target) {
  if (target == "-") return generateScene(kind, size, interruptible(writeToStdout));
  requireWritableFile(target);
  AtomicFile file(target);
  const auto append = [&](std::string_view block) { file.write(std::as_bytes(std::span(block))); };
  generateScene(kind, size, interruptible(append));
  file.commit();
}

}  // namespace

ExitCode runGenerate(const Arguments& arguments, const Log& log) {
  const Kind& kind = kindNamed(arguments.files.front());
  const std::uint32_t size = sizeFor(kind, arguments);
  writeScene(kind, size, arguments.generatedFile);
  log.note(fmt::format("{} of size {}: {} primitives", kind.name, size, kind.primitiveCount(size)));
  return ExitCode::done;
}

}  // namespace candela::cli
