// The command line: one word per line.
#include "host/app/cli/command_line.h"

#include <sstream>

#include "tests/fuzz/fuzz.h"

void candela::fuzz::run(Input input) {
  std::istringstream lines(textOf(input));
  std::vector<std::string> words;
  for (std::string word; std::getline(lines, word);) words.push_back(word.substr(0, word.find('\0')));
  expectErrors([&] { cli::parseCommandLine(words); });
}
