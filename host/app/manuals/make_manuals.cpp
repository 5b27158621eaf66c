// Writes the manual pages and the completions, compressed where packages compress them, into a folder.
#include <zlib.h>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "host/app/cli/commands.h"
#include "host/app/manuals/completions.h"
#include "host/app/manuals/manual_page.h"

namespace {

using namespace candela;

void write(const std::filesystem::path& file, const std::string& text) {
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  if (!stream.flush()) throw std::runtime_error("cannot write " + file.string());
}

// The header of the result has no time and no name, so that equal pages give equal files.
void writeCompressed(const std::filesystem::path& file, const std::string& text) {
  const std::unique_ptr<gzFile_s, int (*)(gzFile)> stream(gzopen(file.c_str(), "wb9"), gzclose);
  const auto size = static_cast<unsigned>(text.size());
  if (!stream || gzwrite(stream.get(), text.data(), size) != static_cast<int>(size)) {
    throw std::runtime_error("cannot write " + file.string());
  }
}

void writeAll(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  writeCompressed(folder / "candela.1.gz", manuals::manualPage({}));
  for (const cli::CommandInfo& info : cli::commandTable()) {
    writeCompressed(folder / (manuals::pageName(info.command) + ".1.gz"), manuals::manualPage(info.command));
  }
  write(folder / "candela.bash", manuals::bashCompletion());
  write(folder / "_candela", manuals::zshCompletion());
  write(folder / "candela.fish", manuals::fishCompletion());
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) {
    std::cerr << "usage: candela_make_manuals FOLDER\n";
    return 1;
  }
  try {
    writeAll(arguments[1]);
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "candela_make_manuals: " << error.what() << '\n';
    return 1;
  }
}
