// `candela kernels` on a device, and its comparison of two reports.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/app/cli/run_program.h"

namespace candela {
namespace {

using Catch::Contains;
using nlohmann::json;

class Kernels {
 public:
  Kernels() : scene_(folder_.write("a.p3f", smallScene())) {}

  const std::string& scene() const { return scene_; }
  std::string path(const std::string& name) const { return folder_.path(name); }
  std::string write(const std::string& name, const std::string& text) const { return folder_.write(name, text); }

  ProgramResult run(const std::vector<std::string>& options) const {
    std::vector<std::string> words{"kernels"};
    words.insert(words.end(), options.begin(), options.end());
    if (const char* device = std::getenv("CANDELA_TEST_DEVICE")) words.insert(words.end(), {"--device", device});
    return runCandela(words);
  }

  json report(std::vector<std::string> words = {}) const {
    words.insert(words.begin(), {scene_, "--json", "-"});
    const ProgramResult result = run(words);
    INFO(result.err);
    REQUIRE(result.exitCode == 0);
    return json::parse(result.out);
  }

 private:
  TemporaryFolder folder_;
  std::string scene_;
};

std::vector<std::string> namesIn(const json& report) {
  std::vector<std::string> names;
  for (const json& row : report["rows"]) names.push_back(row["kernel"]);
  return names;
}

// The environment in which RADV opens an RX 6800 that is not there; empty without RADV.
std::vector<std::string> withNullHardware() {
  for (const std::string file : {"radeon_icd.json", "radeon_icd.x86_64.json"}) {
    const std::string path = "/usr/share/vulkan/icd.d/" + file;
    if (!std::filesystem::exists(path)) continue;
    return {"VK_DRIVER_FILES=" + path, "VK_ICD_FILENAMES=" + path, "RADV_FORCE_FAMILY=navi21"};
  }
  return {};
}

const std::vector<std::string> kWavefront{"wavefront.gather", "wavefront.extend", "wavefront.shade", "wavefront.shadow",
                                          "wavefront.renew"};

}  // namespace

TEST_CASE("kernels reports those of a render with its settings, with sizes and times", "[swiftshader-slow]") {
  const Kernels kernels;
  const json report = kernels.report({"--workgroup", "16x4", "--loads", "storage"});
  REQUIRE(namesIn(report) == std::vector<std::string>{"megakernel"});
  const json& row = report["rows"][0];
  CHECK(row["scene"] == "a.p3f");
  CHECK(row["workgroup"] == "16x4");
  CHECK(row["sceneLoads"] == "storage");
  CHECK(row["spirvBytes"].get<double>() > 1000);
  CHECK(row["cacheBytes"].get<double>() > 0);
  CHECK(row["compileSeconds"].get<double>() >= 0);
}

TEST_CASE("the kernels that are reported are those that a render uses", "[swiftshader-slow]") {
  const Kernels kernels;
  CHECK(namesIn(kernels.report({"--kernel", "wavefront"})) == kWavefront);
  std::vector<std::string> all{"megakernel"};
  all.insert(all.end(), kWavefront.begin(), kWavefront.end());
  CHECK(namesIn(kernels.report({"--all-kernels"})) == all);
  CHECK(namesIn(kernels.report({"--integrator", "normal", "--all-kernels"})) == std::vector<std::string>{"views"});
  const json plain = kernels.report(), layered = kernels.report({"--aov", "normal,albedo"});
  CHECK(layered["rows"][0]["spirvBytes"] > plain["rows"][0]["spirvBytes"]);
  const ProgramResult both = kernels.run({kernels.scene(), "--all-kernels", "--kernel", "wavefront"});
  CHECK(both.exitCode == 1);
  CHECK_THAT(both.err, Contains("--all-kernels and --kernel exclude each other"));
}

TEST_CASE("kernels says so where a driver reports nothing", "[swiftshader-slow]") {
  const Kernels kernels;
  const json report = kernels.report();
  const bool hasStatistics = report["hasStatistics"];
  CHECK(report["rows"][0]["executables"].empty() == !hasStatistics);
  CHECK(report["rows"][0]["registers"].is_null() == !hasStatistics);  // which every driver with statistics reports
  const ProgramResult text = kernels.run({kernels.scene()});
  CHECK(contains(text.out, "This driver reports no statistics") == !hasStatistics);
  CHECK_THAT(text.out, Contains("SPIR-V bytes") && Contains("ms to compile") && Contains("workgroup 8x8"));
}

TEST_CASE("a comparison of kernels ends with 0 if nothing is worse, else with 3", "[swiftshader-slow]") {
  const Kernels kernels;
  json report = kernels.report();
  const std::string before = kernels.path("before.json"), after = kernels.path("after.json");
  report["rows"][0]["instructions"] = 1000;
  kernels.write("before.json", report.dump());
  CHECK(runCandela({"kernels", "compare", before, before}).exitCode == 0);
  report["rows"][0]["instructions"] = 1040;
  kernels.write("after.json", report.dump());
  CHECK(runCandela({"kernels", "compare", before, after}).exitCode == 0);
  const ProgramResult worse = runCandela({"kernels", "compare", before, after, "--threshold", "0.01"});
  CHECK(worse.exitCode == 3);
  CHECK_THAT(worse.out, Contains("instructions") && Contains("+4.0 %") && Contains("worse"));
  CHECK(runCandela({"kernels", "compare", after, before, "--threshold", "0.01"}).exitCode == 0);
}

TEST_CASE("a comparison of kernels refuses other files, numbers of files and options of scenes") {
  const Kernels kernels;
  const std::string empty = kernels.write("empty.json", ""), scene = kernels.scene();
  const std::string out = kernels.path("out.json");
  CHECK(runCandela({"kernels", "compare", empty, empty, "--json", out}).exitCode == 2);
  CHECK(runCandela({"kernels", "compare", empty, kernels.path("absent.json")}).exitCode == 2);
  CHECK_FALSE(std::filesystem::exists(out));
  CHECK(runCandela({"kernels", "compare", scene}).exitCode == 1);
  const ProgramResult option = runCandela({"kernels", "compare", empty, empty, "--spp", "4"});
  CHECK(option.exitCode == 1);
  CHECK_THAT(option.err, Contains("kernels compare --spp: this option applies only to kernels SCENE"));
}

TEST_CASE("a GPU that is not there compiles and reports, and devices, doctor and render say what it is") {
  const Kernels kernels;
  const Surroundings surroundings{withNullHardware(), {}, {}};
  const ProgramResult devices = runCandela({"devices"}, surroundings);
  if (!contains(devices.out, "Null hardware")) {
    WARN("this machine has no RADV, or one of Mesa 26 or later, which has no null hardware");
    return;
  }
  CHECK_THAT(devices.out, Contains("NOT USABLE: there is no such GPU: RADV_FORCE_FAMILY stands in for it"));
  CHECK_THAT(runCandela({"doctor"}, surroundings).out, Contains("`candela kernels` reports what this one compiles"));
  const ProgramResult render = runCandela({kernels.scene(), "-o", kernels.path("a.png")}, surroundings);
  CHECK(render.exitCode == 4);
  CHECK_THAT(render.err, Contains("there is no such GPU"));

  const ProgramResult result = runCandela({"kernels", kernels.scene(), "--all-kernels", "--json", "-"}, surroundings);
  INFO(result.err);
  REQUIRE(result.exitCode == 0);
  const json report = json::parse(result.out);
  CHECK(report["rows"].size() == 6);
  for (const json& row : report["rows"]) {
    CAPTURE(row["kernel"]);
    CHECK(row["occupancyFraction"].get<double>() > 0);
    CHECK(row["occupancyFraction"].get<double>() <= 1);
    for (const char* figure : {"registers", "instructions", "cycles", "codeBytes"})
      CHECK(row[figure].get<double>() > 0);
    for (const char* figure : {"spillsToMemory", "spillsToRegisters"}) CHECK(row[figure].is_number());
  }
  const ProgramResult cases = runCandela({"conformance", "--compile-only", "--cases", "leaf.film.*"}, surroundings);
  INFO(cases.err);
  CHECK(cases.exitCode == 0);
  CHECK(runCandela({"conformance", "--cases", "leaf.film.*"}, surroundings).exitCode == 4);
}

TEST_CASE("the reference has no kernels, and without a valid scene nothing is written") {
  const Kernels kernels;
  const ProgramResult reference = runCandela({"kernels", kernels.scene(), "--device", "cpu"});
  CHECK(reference.exitCode == 1);
  CHECK_THAT(reference.err, Contains("the reference tracer has no kernels"));
  const std::string out = kernels.path("out.json");
  CHECK(kernels.run({kernels.path("absent.p3f"), "--json", out}).exitCode == 2);
  CHECK_FALSE(std::filesystem::exists(out));
}

}  // namespace candela
