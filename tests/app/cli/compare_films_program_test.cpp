// `candela compare A B` of films with variance: verdicts, refusals, and the combination of --tolerance and --alpha.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/app/cli/run_program.h"

namespace candela {
namespace {

using Catch::Contains;
using nlohmann::json;

// A ball on a floor under a light of the given red, green and blue, 16x12 pixels, by the reference.
std::string renderFilm(const TemporaryFolder& folder, const std::string& name, const std::string& seed,
                       const std::string& lamp = "4 4 4", const std::vector<std::string>& options = {}) {
  std::string text = smallScene();
  text.replace(text.find("4 4 4"), 5, lamp);
  const std::string file = folder.path(name);
  std::vector<std::string> words{folder.write("scene.p3f", text), "-o", file, "--device", "cpu", "--seed", seed, "-q"};
  words.insert(words.end(), options.begin(), options.end());
  REQUIRE(runCandela(words).exitCode == 0);
  return file;
}

}  // namespace

TEST_CASE("films of one scene with two seeds show the same light in verdict and JSON") {
  const TemporaryFolder folder;
  const std::string a = renderFilm(folder, "a.exr", "1");
  const std::string b = renderFilm(folder, "b.exr", "2");
  const ProgramResult text = runCandela({"compare", a, b, "--bias", "60%"});
  CHECK(text.exitCode == 0);
  CHECK_THAT(text.out, Contains("A and B show the same light"));
  const json report = json::parse(runCandela({"compare", a, b, "--alpha", "1%", "--bias", "60%", "--json", "-"}).out);
  CHECK(report["agrees"] == true);
  CHECK(report["sameLight"]["alpha"] == 0.01);
  CHECK(report["sameLight"]["regions"].size() == 5);  // the image, and tiles of 8 pixels
}

TEST_CASE(
    "films whose noise may hide more than 1 % are not decided, with an exit code of its own, unless that is allowed") {
  const TemporaryFolder folder;
  const std::string a = renderFilm(folder, "a.exr", "1");
  const std::string b = renderFilm(folder, "b.exr", "2");
  const ProgramResult text = runCandela({"compare", a, b});
  CHECK(text.exitCode == 8);
  CHECK_THAT(text.out, Contains("same light?           not decided") && Contains("Not decided: noise may hide") &&
                           Contains("A is") && !Contains("show the same light"));
  CHECK(runCandela({"compare", a, b, "--allow-undecided", "-q"}).exitCode == 0);
  const json report = json::parse(runCandela({"compare", a, b, "--json", "-"}).out);
  CHECK(report["agrees"].is_null());
  CHECK(report["sameLight"]["undecided"]["reason"] == "noise");
  const std::string page = folder.path("report.html");
  runCandela({"compare", a, b, "--report", page, "-q"});
  CHECK_THAT(readText(page), Contains("verdict undecided") && Contains("It is not decided."));
}

TEST_CASE("films of different light differ, with exit code 3 and the position, for any sampler") {
  const TemporaryFolder folder;
  const std::string a = renderFilm(folder, "a.exr", "1", "6 6 6");
  for (const char* sampler : {"independent", "stratified", "sobol"}) {
    const std::string b = renderFilm(folder, "b.exr", "2", "4 4 4", {"--sampler", sampler});
    const ProgramResult result = runCandela({"compare", a, b});
    INFO(sampler << result.out);
    CHECK(result.exitCode == 3);
    CHECK_THAT(result.out, Contains("do NOT show the same light") && Contains("brighter in A"));
  }
}

TEST_CASE("films of the same seed have no verdict, and --alpha is refused") {
  const TemporaryFolder folder;
  const std::string a = renderFilm(folder, "a.exr", "1");
  const std::string b = renderFilm(folder, "b.exr", "1", "6 6 6");
  const ProgramResult silent = runCandela({"compare", a, b});
  CHECK(silent.exitCode == 0);
  CHECK_THAT(silent.out, Contains("There is no verdict on the light: A and B have the same seed"));
  CHECK(json::parse(runCandela({"compare", a, b, "--json", "-"}).out)["agrees"].is_null());
  const ProgramResult asked = runCandela({"compare", a, b, "--alpha", "0.01"});
  CHECK(asked.exitCode == 1);
  CHECK_THAT(asked.err, Contains("--alpha: A and B have the same seed"));
}

TEST_CASE("the option --alpha requires variance and two samples in every pixel") {
  const TemporaryFolder folder;
  const std::string a = renderFilm(folder, "a.exr", "1");
  const std::string bare = renderFilm(folder, "b.pfm", "2");
  const std::string single = renderFilm(folder, "c.exr", "2", "4 4 4", {"--spp", "1"});
  CHECK(runCandela({"compare", a, bare}).exitCode == 0);
  CHECK_THAT(runCandela({"compare", a, bare, "--alpha", "0.01"}).err, Contains("B has no variance"));
  CHECK_THAT(runCandela({"compare", a, single, "--alpha", "0.01"}).err,
             Contains("B has pixels with fewer than two samples"));
}

TEST_CASE("the option --tolerance alone replaces the statistical test, and with --alpha both criteria must be met") {
  const TemporaryFolder folder;
  const std::string a = renderFilm(folder, "a.exr", "1", "6 6 6");
  const std::string b = renderFilm(folder, "b.exr", "2");
  const std::string c = renderFilm(folder, "c.exr", "3");
  CHECK(runCandela({"compare", a, b, "--tolerance", "1e9"}).exitCode == 0);
  CHECK(runCandela({"compare", a, b, "--tolerance", "1e9", "--alpha", "0.01"}).exitCode == 3);
  CHECK(runCandela({"compare", b, c, "--tolerance", "1e9", "--alpha", "0.01"}).exitCode == 8);
  CHECK(runCandela({"compare", b, c, "--tolerance", "1e9", "--alpha", "0.01", "--bias", "60%"}).exitCode == 0);
  CHECK(runCandela({"compare", b, c, "--tolerance", "1e-9", "--alpha", "0.01"}).exitCode == 3);
}

TEST_CASE("a report on two films is one page, the same each time, written completely or not at all") {
  const TemporaryFolder folder;
  const std::string a = renderFilm(folder, "a.exr", "1");
  const std::string b = renderFilm(folder, "b.exr", "2");
  const std::string page = folder.path("report.html");
  CHECK(runCandela({"compare", a, b, "--bias", "60%", "--report", page, "-q"}).exitCode == 0);
  const std::string first = readText(page);
  CHECK_THAT(first, Contains("A and B show the same light") && Contains("map-t8") &&
                        Contains("candela render scene.p3f --spp 16"));
  CHECK(runCandela({"compare", a, b, "--bias", "60%", "--report", page, "-q"}).exitCode == 0);
  CHECK(readText(page) == first);

  const std::size_t files = folder.fileCount();
  CHECK(runCandela({"compare", a, folder.path("missing.exr"), "--report", folder.path("other.html")}).exitCode == 2);
  CHECK(runCandela({"compare", a, b, "--report", folder.path("missing/other.html")}).exitCode == 2);
  CHECK(folder.fileCount() == files);
}

}  // namespace candela
