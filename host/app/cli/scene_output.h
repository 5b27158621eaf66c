// Writes generated scenes.
#pragma once
#include <functional>
#include <string>

#include "host/scene/generate/nff_writer.h"

namespace candela::cli {

/// Passes a sink to `write` whose blocks go to a file, which appears only when it is complete, or to stdout if `target`
/// is "-". Throws FileError if writing fails, and InterruptedError at the first block after Ctrl-C.
void writeSceneText(const std::string& target, const std::function<void(const generate::NffWriter::Sink&)>& write);

}  // namespace candela::cli
