// Refuses outputs that would replace each other or a file that the command reads.
#pragma once
#include "host/app/cli/command_arguments.h"

namespace candela::cli {

/// Throws UsageError if two outputs of the command are the same file, or if an output is a file that the command line
/// names for reading. Only a render may replace such a file: the film that it resumes. Devices and pipes may be shared.
void requireSeparateFiles(const Arguments& arguments);
/// Throws UsageError if an output of the command is one of these files, which a scene has read
/// (scene::LoadedScene::files). Every command that loads a scene calls it before its first write.
void requireUnread(const Arguments& arguments, const std::vector<std::filesystem::path>& files);

}  // namespace candela::cli
