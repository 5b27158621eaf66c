// Compiles and runs reproduce.c of a capture.
#pragma once
#include <string>
#include <vector>

#include "tests/app/cli/run_program.h"
#include "tests/drivers/capture/miscompiled.h"

namespace candela {

/// Runs `candela capture` with `words` and -o, in an environment; requires that it succeeds.
ProgramResult captureTo(const std::string& folder, std::vector<std::string> words,
                        const std::vector<std::string>& environment = {});

/// Compiles reproduce.c in the folder with all warnings as errors, by each C compiler that there is. Checks that there
/// is no message and that the file has at most 500 lines.
void compileReproducer(const std::string& folder);

/// Runs a shell command in the folder, by default the program.
ProgramResult runIn(const std::string& folder, const std::vector<std::string>& environment = {},
                    const std::string& command = "./reproduce");

/// A change of miscompiler.cpp: OpISubBorrow instead of OpIAddCarry.
inline constexpr const char* kBorrowsInsteadOfCarrying = "149:all:150";

}  // namespace candela
