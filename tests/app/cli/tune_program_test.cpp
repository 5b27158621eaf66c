// `candela tune` on a device, and renders with the stored choices.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "host/measure/tune/tuning_file.h"
#include "tests/app/cli/json_rules.h"
#include "tests/app/cli/run_program.h"
#include "tests/measure/tune/made_rows.h"

namespace candela {
namespace {

using Catch::Contains;
using nlohmann::json;

// More primitives than are tested without a structure.
std::string sceneWithATree() {
  std::string spheres;
  for (int i = 0; i < 60; ++i) spheres += fmt::format("s {} 0.5 {} 0.04\n", 0.05 * i - 1.5, 0.015 * i);
  return smallScene(spheres);
}

Surroundings inside(const std::vector<std::string>& environment) { return {environment, {}, {}}; }

// A scene, a folder for tuning results, and the program with both.
class Home {
 public:
  Home() : scene_(folder_.write("a.p3f", sceneWithATree())) { std::filesystem::create_directory(cache()); }

  std::string cache() const { return folder_.path("cache"); }
  std::string path(const std::string& name) const { return folder_.path(name); }
  const std::string& scene() const { return scene_; }

  std::vector<std::string> kept() const {
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(cache())) {
      if (entry.path().extension() == ".json") files.push_back(entry.path().string());
    }
    return files;
  }

  ProgramResult run(std::vector<std::string> words, Surroundings surroundings = {}) const {
    if (const char* device = std::getenv("CANDELA_TEST_DEVICE")) words.insert(words.end(), {"--device", device});
    surroundings.environment.push_back("CANDELA_CACHE_DIR=" + cache());
    return runCandela(words, surroundings);
  }

  /// Tunes as fast as can be.
  ProgramResult tune(std::vector<std::string> words = {}, const Surroundings& surroundings = {}) const {
    words.insert(words.begin(), {"tune", scene_, "--size", "16x12", "--spp", "1", "--repeat", "1"});
    return run(words, surroundings);
  }

  /// Renders, and returns the JSON report.
  json render(const std::vector<std::string>& options = {}) const {
    std::vector<std::string> words{scene_, "--spp", "2", "--json", "-"};
    words.insert(words.end(), options.begin(), options.end());
    const ProgramResult result = run(words);
    INFO(result.err);
    REQUIRE(result.exitCode == 0);
    return json::parse(result.out);
  }

  /// Stores a choice, given by indices of values, as if it had been the fastest; returns the file.
  std::string keep(const tune::Candidate& candidate) const {
    const char* const device = std::getenv("CANDELA_TEST_DEVICE");
    const cache::DeviceKey key = cache::keyOf(vulkan::selectDevice(device == nullptr ? "" : device));
    const std::filesystem::path file = std::filesystem::path(cache()) / cache::fileNameOf("tune", key, "json");
    tune::writeTuning(file, key, {candidate, "2026-01-31T12:00:00Z"});
    return file.string();
  }

 private:
  TemporaryFolder folder_;
  std::string scene_;
};

}  // namespace

TEST_CASE("tune stores its result for this device and reports its measurements", "[swiftshader-slow]") {
  const Home home;
  const ProgramResult tuned = home.tune({"--json", home.path("report.json")});
  INFO(tuned.out << tuned.err);
  REQUIRE(tuned.exitCode == 0);
  CHECK_THAT(tuned.out, Contains("chosen: layout=") && Contains("stored in " + home.cache()));
  const json report = json::parse(readText(home.path("report.json")));
  CHECK(report["rows"].size() >= 4 + 5);
  for (const json& row : report["rows"]) CHECK(row["agrees"] == true);
  REQUIRE(home.kept().size() == 1);
  CHECK(report["file"] == home.kept().front());
  CHECK(json::parse(readText(home.kept().front()))["choice"] == report["chosen"]);
  CHECK(home.keep(tune::builtIn()) == home.kept().front());
  CHECK(home.kept().size() == 1);
}

TEST_CASE("a dry run stores nothing", "[slow]") {
  const Home home;
  const ProgramResult result = home.tune({"--dry-run", "--json", "-"});
  INFO(result.err);
  REQUIRE(result.exitCode == 0);
  CHECK(json::parse(result.out)["file"].is_null());
  CHECK(violationsOf(nlohmann::ordered_json::parse(result.out), "candela-tune-report/2") == std::vector<std::string>{});
  CHECK(home.kept().empty());
}

TEST_CASE("tuned values are used and reported if an option is auto, and change no bit of the film",
          "[swiftshader-slow]") {
  const Home home;
  const json plain = home.render();
  CHECK(plain["auto"] == "built-in");
  const std::string file = home.keep(
      tune::candidateWith({{"layout", "bvh2"}, {"loads", "storage"}, {"workgroup", "16x4"}}));
  const json tuned = home.render();
  CHECK(tuned["layout"] == "bvh2");
  CHECK(tuned["sceneLoads"] == "storage");
  CHECK(tuned["workgroup"] == "16x4");
  CHECK(tuned["auto"] == "tuned 2026-01-31T12:00:00Z, " + file);
  CHECK(tuned["filmHash"] == plain["filmHash"]);

  const json asked = home.render({"--layout", "cwbvh", "--loads", "texel", "--workgroup", "32x1"});
  CHECK(asked["layout"] == "cwbvh");
  CHECK(asked["sceneLoads"] == "texel");
  CHECK(asked["workgroup"] == "32x1");
  CHECK(asked["filmHash"] == plain["filmHash"]);

  const json untuned = home.render({"--untuned"});
  for (const char* key : {"layout", "sceneLoads", "workgroup", "auto", "filmHash"}) CHECK(untuned[key] == plain[key]);
}

TEST_CASE("candela devices lists stored tuning, and benchmarks use it", "[swiftshader-slow]") {
  const Home home;
  const Surroundings surroundings = inside({"CANDELA_CACHE_DIR=" + home.cache()});
  const auto isTuned = [](const json& device) { return device["tuned"].is_object(); };
  CHECK(
      std::ranges::none_of(json::parse(runCandela({"devices", "--json", "-"}, surroundings).out)["devices"], isTuned));
  home.keep(tune::candidateWith({{"layout", "bvh2"}, {"workgroup", "16x8"}}));
  CHECK(std::ranges::any_of(json::parse(runCandela({"devices", "--json", "-"}, surroundings).out)["devices"], isTuned));
  CHECK_THAT(runCandela({"devices"}, surroundings).out,
             Contains("tuned 2026-01-31T12:00:00Z: layout=bvh2 loads=auto workgroup=16x8"));
  const ProgramResult bench = home.run(
      {"bench", home.scene(), "--size", "8x8", "--spp", "1", "--repeat", "1", "--json", "-"});
  REQUIRE(bench.exitCode == 0);
  CHECK(json::parse(bench.out)["rows"][0]["workgroup"] == "16x8");
  const ProgramResult rays = home.run({"bench", "rays", home.scene(), "--size", "8x8", "--repeat", "1", "--json", "-"});
  REQUIRE(rays.exitCode == 0);
  CHECK(json::parse(rays.out)["rows"][0]["workgroup"] == "16x8");
}

TEST_CASE("a damaged tuning file is ignored with one warning, which --quiet hides", "[swiftshader-slow]") {
  const Home home;
  const std::string file = home.keep(tune::candidateWith({{"workgroup", "16x8"}}));
  std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
  const ProgramResult result = home.run({home.scene(), "--spp", "2", "--json", "-"});
  REQUIRE(result.exitCode == 0);
  CHECK(json::parse(result.out)["auto"] == "built-in");
  const std::size_t warning = result.err.find("warning: " + file + " is ignored: it is damaged");
  REQUIRE(warning != std::string::npos);
  CHECK(result.err.find("warning: ", warning + 1) == std::string::npos);
  CHECK(home.run({home.scene(), "--spp", "2", "--stats", "-q"}).err.empty());
}

TEST_CASE("tune fails at once if nothing can be stored, and renders work as before", "[swiftshader-slow]") {
  const Home home;
  const std::string file = home.scene();
  const std::vector<std::pair<std::vector<std::string>, std::string>> places{
      {{"CANDELA_CACHE_DIR=" + file + "/cache"}, "is not a folder"},
      {{"CANDELA_CACHE_DIR=", "XDG_CACHE_HOME=", "HOME="}, "no folder for the result"}};
  for (const auto& [environment, message] : places) {
    const ProgramResult tuned = home.tune({"--spp", "1000000"}, inside(environment));
    CHECK(tuned.exitCode == 2);
    CHECK_THAT(tuned.err, Contains(message));
    const ProgramResult rendered = home.run({home.scene(), "--spp", "2", "--stats"}, inside(environment));
    CHECK(rendered.exitCode == 0);
    CHECK_THAT(rendered.out, Contains("built-in"));
    CHECK_THAT(rendered.err, !Contains("warning"));
  }
}

TEST_CASE("the reference cannot be tuned, and an invalid scene is reported") {
  const Home home;
  CHECK(runCandela({"tune", "--device", "cpu"}).exitCode == 1);
  CHECK(home.run({"tune", home.path("absent.p3f")}).exitCode == 2);
  CHECK(home.kept().empty());
}

TEST_CASE("Ctrl-C during tuning stores nothing and exits with 7", "[swiftshader-slow]") {
  const Home home;
  Surroundings surroundings;
  surroundings.interruptAfter = std::chrono::milliseconds(3000);
  const ProgramResult result = home.tune({"--spp", "1000000000", "--json", home.path("report.json")}, surroundings);
  INFO(result.err);
  CHECK(result.exitCode == 7);
  CHECK(home.kept().empty());
  CHECK_FALSE(std::filesystem::exists(home.path("report.json")));
}

}  // namespace candela
