// Calls compilers as README.md of a capture describes.
#include "tests/drivers/capture/reproducer.h"

#include <algorithm>
#include <catch2/catch.hpp>

namespace candela {

ProgramResult captureTo(const std::string& folder, std::vector<std::string> words,
                        const std::vector<std::string>& environment) {
  words.insert(words.begin(), "capture");
  words.insert(words.end(), {"-o", folder});
  ProgramResult result = runCandela(words, {.environment = environment});
  INFO(result.err);
  REQUIRE(result.exitCode == 0);
  return result;
}

void compileReproducer(const std::string& folder) {
  const std::string source = readText(folder + "/reproduce.c");
  CHECK(std::ranges::count(source, '\n') <= 500);
  for (const std::string compiler : {CANDELA_CLANG, CANDELA_C_COMPILER}) {
    if (compiler.empty()) continue;
    const ProgramResult result = runIn(
        folder, {}, compiler + " -std=c99 -Wall -Wextra -pedantic -Werror -o reproduce reproduce.c -lvulkan");
    INFO(compiler << ": " << result.err);
    REQUIRE(result.exitCode == 0);
    CHECK(result.err.empty());
  }
}

ProgramResult runIn(const std::string& folder, const std::vector<std::string>& environment,
                    const std::string& command) {
  return runProgram("/bin/sh", {"-c", "cd \"$0\" && " + command, folder}, {.environment = environment});
}

}  // namespace candela
