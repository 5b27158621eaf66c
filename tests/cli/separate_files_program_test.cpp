// No output of a command replaces another one, or a file that the command reads.
#include <catch2/catch.hpp>
#include <filesystem>

#include "tests/cli/film_runs.h"

namespace candela {
namespace {

using Catch::Contains;
using Words = std::vector<std::string>;

// Requires that the command ends with exit code 1 and this message before it writes anything.
void requireRefused(const TemporaryFolder& folder, const Words& words, const std::string& message) {
  const std::size_t before = folder.fileCount();
  const ProgramResult result = runCandela(words);
  INFO(Catch::StringMaker<Words>::convert(words));
  CHECK(result.exitCode == 1);
  CHECK_THAT(result.err, Contains(message));
  CHECK(folder.fileCount() == before);
}

Words withOptions(const std::string& scene, const Words& options) {
  Words words{scene, "--device", "cpu", "--size", "8x8", "--spp", "1", "-q"};
  words.insert(words.end(), options.begin(), options.end());
  return words;
}

}  // namespace

TEST_CASE("two outputs of a command are never the same file, whether it exists or not") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const std::string film = folder.path("f.exr");
  const auto refuse = [&](const Words& options, const std::string& message) {
    requireRefused(folder, withOptions(scene, options), message);
  };
  refuse({"--checkpoint", film, "-o", film}, "f.exr: -o and --checkpoint would both write this file");
  refuse({"--checkpoint", film, "--json", film + ".json"}, "--json and the report of --checkpoint would both");
  std::filesystem::create_directory(folder.path("b"));
  refuse({"-o", folder.path("q.png"), "--json", folder.path("b/../q.png")}, "--json and -o would both");
  folder.write("q.png", "an old picture");
  std::filesystem::create_symlink("q.png", folder.path("link"));
  refuse({"-o", folder.path("q.png"), "--json", folder.path("link")}, "--json and -o would both");
}

TEST_CASE("outputs that are separate, stdout or devices are written") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const std::string film = folder.path("f.exr");
  CHECK(runCandela(withOptions(scene, {"--checkpoint", film, "-o", folder.path("p.exr"), "--json", "-"})).exitCode ==
        0);
  CHECK(runCandela(withOptions(scene, {"--checkpoint", film, "--resume", film, "--json", "/dev/null"})).exitCode == 0);
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder.path());
  folder.write("balls", "a file whose name is a kind of scene, which is no input");
  CHECK(runCandela({"generate", "balls", "-o", "balls", "-q"}).exitCode == 0);
  std::filesystem::current_path(before);
}

TEST_CASE("a merge never replaces one of its films, nor its report") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const std::string a = folder.path("a.exr");
  const std::string b = folder.path("b.exr");
  const std::string bytes = kReference.film(scene, a, {"--samples", "0:4"});
  kReference.film(scene, b, {"--samples", "4:12"});
  requireRefused(folder, {"merge", a, b, "-o", a},
                 "a.exr: this file is read by the command, and -o would overwrite it");
  requireRefused(folder, {"merge", a, b, "-o", folder.path("c.exr"), "--json", a + ".json"}, "--json would overwrite");
  requireRefused(folder, {"film", a, "--json", a + ".json"}, "--json would overwrite");
  CHECK(readText(a) == bytes);
}

}  // namespace candela
