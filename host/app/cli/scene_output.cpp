// Writes blocks of text to a file or to stdout.
#include "host/app/cli/scene_output.h"

#include <atomic>
#include <iostream>
#include <span>

#include "host/app/cli/output_check.h"
#include "host/base/atomic_file.h"
#include "host/base/errors.h"
#include "host/base/interrupt.h"
#include "host/base/standard_output.h"

namespace candela::cli {
namespace {

using Sink = generate::NffWriter::Sink;

/// Passes blocks on until Ctrl-C. An incomplete scene is useless, so that no file appears.
Sink interruptible(Sink sink) {
  const std::atomic<bool>& interrupted = watchInterrupts();
  return [&interrupted, sink = std::move(sink)](std::string_view block) {
    if (interrupted) throw InterruptedError("interrupted before the scene was complete");
    sink(block);
  };
}

void writeToStdout(std::string_view block) {
  if (!std::cout.write(block.data(), static_cast<std::streamsize>(block.size()))) throw StdoutError();
}

}  // namespace

void writeSceneText(const std::string& target, const std::function<void(const Sink&)>& write) {
  if (target == "-") return write(interruptible(writeToStdout));
  requireWritableFile(target);
  AtomicFile file(target);
  write(interruptible([&](std::string_view block) { file.write(std::as_bytes(std::span(block))); }));
  file.commit();
}

}  // namespace candela::cli
