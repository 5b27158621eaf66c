// Where commands that write scenes write them to.
#pragma once
#include <functional>
#include <string>

#include "host/generate/nff_writer.h"

namespace candela::cli {

/// Hands `write` a sink whose blocks become a file, there as a whole or not at all, or go to stdout if `target` is "-".
/// Throws FileError if they cannot, InterruptedError at the first block after Ctrl-C.
void writeSceneText(const std::string& target, const std::function<void(const generate::NffWriter::Sink&)>& write);

}  // namespace candela::cli
