// The text of capture.h, which describes the work to reproduce.c.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "host/drivers/capture/capture.h"

namespace candela::capture {

/// Returns the word with which the whole buffer begins, if all of its words are equal.
std::optional<std::uint32_t> commonWord(const Content& content);

/// Returns the name of a file of the folder, e.g. "module_0.spv".
std::string moduleFile(std::size_t index);
std::string bufferFile(std::size_t index);
/// The file of the data of a RecordedWrite, by the index of the command.
std::string writeFile(std::size_t command);

/// Returns a C header. Throws UsageError if the work has more objects than reproduce.c takes.
std::string headerText(const Capture& capture);

}  // namespace candela::capture
