// The program on a Vulkan device. The validation layer is enabled in it, too: a message of the layer ends it with exit
// code 70.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "host/image/image.h"
#include "tests/app/cli/run_program.h"

namespace candela {
namespace {

using nlohmann::json;

// `words` on the device that the tests run on.
ProgramResult runOnDevice(std::vector<std::string> words, const Surroundings& surroundings = {}) {
  if (const char* device = std::getenv("CANDELA_TEST_DEVICE")) words.insert(words.end(), {"--device", device});
  return runCandela(words, surroundings);
}

json reportOf(const std::string& scene, const std::vector<std::string>& options) {
  std::vector<std::string> words{scene, "--json", "-", "--spp", "2"};
  words.insert(words.end(), options.begin(), options.end());
  const ProgramResult result = runOnDevice(words);
  INFO(result.err);
  REQUIRE(result.exitCode == 0);
  return json::parse(result.out);
}

}  // namespace

TEST_CASE("devices are listed as text and as JSON") {
  const ProgramResult text = runCandela({"devices"});
  REQUIRE(text.exitCode == 0);
  const json devices = json::parse(runCandela({"devices", "--json", "-"}).out)["devices"];
  REQUIRE_FALSE(devices.empty());
  for (const json& device : devices) CHECK(contains(text.out, device["name"]));
  CHECK(devices[0]["usable"] == true);
  CHECK(devices[0]["maxStorageBufferRange"] > 0);
}

TEST_CASE("the device that is used without --device is marked, and --device lists one device alone") {
  const json devices = json::parse(runCandela({"devices", "--json", "-"}).out)["devices"];
  CHECK(std::ranges::count(devices, json(true), [](const json& device) { return device["default"]; }) == 1);
  const json last = devices.back();
  const ProgramResult one = runCandela({"devices", "--device", std::to_string(devices.size() - 1), "--json", "-"});
  CHECK(json::parse(one.out)["devices"] == json::array({last}));
  const ProgramResult wrong = runCandela({"devices", "--device", "no such device"});
  CHECK(wrong.exitCode == 4);
  CHECK(contains(wrong.err, "no Vulkan device \"no such device\"; available devices:"));
  CHECK(contains(wrong.err, std::string(last["name"])));
  CHECK(runCandela({"devices", "--device", "cpu"}).exitCode == 1);
}

TEST_CASE("a render on a device writes an image that names device and driver") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const std::string exr = folder.path("a.exr");
  const ProgramResult result = runOnDevice({scene, "-o", exr, "--spp", "2"});
  INFO(result.err);
  REQUIRE(result.exitCode == 0);
  const image::Image image = image::readImage(exr);
  CHECK(image.width == 16);
  CHECK(image.metadata.at("candela.device") != "cpu");
  CHECK_FALSE(image.metadata.at("candela.driver").empty());
}

TEST_CASE("requested settings are used and change no bit of the film", "[swiftshader-slow]") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const json plain = reportOf(scene, {});
  CHECK(plain["workgroup"] == "8x8");
  CHECK(plain["structure"] == "bvh");
  CHECK(plain["rays"]["camera"] == 2 * 16 * 12);
  CHECK(plain["truncated"] == 0);

  const json grouped = reportOf(scene, {"--workgroup", "16x4"});
  CHECK(grouped["workgroup"] == "16x4");
  const json brute = reportOf(scene, {"--accel", "none"});
  CHECK(brute["structure"] == "none");
  const json grid = reportOf(scene, {"--accel", "grid", "--grid-density", "3"});
  CHECK(grid["structure"] == "grid");
  CHECK(grid["structureQuality"]["density"] == 3);
  const json midpoint = reportOf(scene, {"--bvh-split", "midpoint"});
  CHECK(midpoint["structure"] == "bvh");
  CHECK(midpoint["bvhSplit"] == "midpoint");
  CHECK(midpoint["bvhQuality"] == "");
  const json high = reportOf(scene, {"--bvh-quality", "high"});
  CHECK(plain["bvhQuality"] == "default");
  CHECK(high["bvhQuality"] == "high");
  const json chopped = reportOf(scene, {"--segments-per-dispatch", "1", "--tile", "5x7"});
  CHECK(chopped["segmentsPerDispatch"] == 1);
  CHECK(chopped["dispatches"]["count"] > plain["dispatches"]["count"]);
  const json waves = reportOf(scene, {"--kernel", "wavefront"});
  CHECK(plain["kernel"] == "megakernel");
  CHECK(waves["kernel"] == "wavefront");
  CHECK(waves["rays"] == plain["rays"]);
  CHECK(waves["traversalSteps"] == plain["traversalSteps"]);
  for (const json& other : {grouped, brute, grid, midpoint, high, chopped, waves})
    CHECK(other["filmHash"] == plain["filmHash"]);
  CHECK(reportOf(scene, {"--seed", "1"})["filmHash"] != plain["filmHash"]);
}

TEST_CASE("a device that does not exist is refused with a list of the existing ones") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const std::string name = json::parse(runCandela({"devices", "--json", "-"}).out)["devices"][0]["name"];
  const ProgramResult result = runCandela({scene, "-o", folder.path("a.png"), "--device", "nosuch"});
  CHECK(result.exitCode == 4);
  CHECK(contains(result.err, name));
  CHECK(folder.fileCount() == 1);
}

TEST_CASE("compare SCENE finds both tracers in agreement") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const ProgramResult result = runOnDevice({"compare", scene, "--size", "64x48"});
  INFO(result.out << result.err);
  CHECK(result.exitCode == 0);
}

TEST_CASE("compare SCENE finds both Whitted tracers in agreement") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene("l 2 -3 9\n"));
  const ProgramResult result = runOnDevice({"compare", scene, "--integrator", "whitted", "--spp", "4"});
  INFO(result.out << result.err);
  CHECK(result.exitCode == 0);
  CHECK(contains(result.out, "they agree"));
}

TEST_CASE("compare SCENE finds wavefront and reference in agreement, path by path") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const ProgramResult result = runOnDevice(
      {"compare", scene, "--size", "64x48", "--kernel", "wavefront", "--spp", "1"});
  INFO(result.out << result.err);
  CHECK(result.exitCode == 0);
  CHECK(contains(result.out, "they agree"));
}

TEST_CASE("kernels are swept, and give the same film", "[swiftshader-slow]") {
  const TemporaryFolder folder;
  const ProgramResult result = runOnDevice({"bench", folder.write("a.p3f", smallScene()), "--spp", "1", "--repeat", "1",
                                            "--sweep", "kernel=megakernel,wavefront", "--json", "-"});
  INFO(result.err);
  REQUIRE(result.exitCode == 0);
  const json rows = json::parse(result.out)["rows"];
  CHECK(rows[0]["kernel"] == "megakernel");
  CHECK(rows[1]["kernel"] == "wavefront");
  CHECK(rows[0]["filmHash"] == rows[1]["filmHash"]);
}

TEST_CASE("compare SCENE finds both tracers' normals in agreement") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const ProgramResult result = runOnDevice({"compare", scene, "--size", "64x48", "--integrator", "normal"});
  INFO(result.out << result.err);
  CHECK(result.exitCode == 0);
  CHECK(contains(result.out, "3072 pixels equal"));
}

TEST_CASE("verify finds the same light on both sides and writes text, JSON and JUnit") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const std::string junit = folder.path("verdict.xml");
  const ProgramResult result = runOnDevice({"verify", scene, "--bias", "5%", "--json", "-", "--junit", junit});
  INFO(result.out << result.err);
  REQUIRE(result.exitCode == 0);
  const json report = json::parse(result.out);
  CHECK(report["agrees"] == true);
  CHECK(report["bias"] == 0.05);
  CHECK(report["sameLight"]["information"] == 1.0);
  CHECK(report["sameLight"]["regions"][0]["detectableBias"] < 0.06);
  CHECK(contains(readText(junit), "failures=\"0\""));
}

TEST_CASE("compare SCENE and verify write a page that names the device, with pictures, maps and the verdict",
          "[swiftshader-slow]") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const std::string page = folder.path("report.html");
  REQUIRE(runOnDevice({"compare", scene, "--report", page, "-q"}).exitCode == 0);
  const std::string compared = readText(page);
  CHECK(contains(compared, "They agree.</strong>"));
  CHECK(contains(compared, "Device: "));
  CHECK(contains(compared, "candela compare " + scene));
  CHECK_FALSE(contains(compared, "map-t8"));

  REQUIRE(runOnDevice({"verify", scene, "--bias", "5%", "--report", page, "-q"}).exitCode == 0);
  const std::string verified = readText(page);
  CHECK(contains(verified, "Device and reference compute the same light"));
  CHECK(contains(verified, "map-t8"));
  CHECK(contains(verified, "candela verify " + scene));
}

TEST_CASE("verify reports a wrong result although both sides agree", "[swiftshader-slow]") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene("# exact-mean: 9 9 9\n"));
  const ProgramResult result = runOnDevice({"verify", scene, "--bias", "10%"});
  INFO(result.out << result.err);
  CHECK(result.exitCode == 3);
  CHECK(contains(result.out, "NOT with the exact result that the scene states"));
}

TEST_CASE("two tracers that agree on bad samples fail only with --strict, and have equal counts",
          "[swiftshader-slow]") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("bright.p3f",
                                         "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 40\nhither 1\nresolution 8 8\nf 0 0 "
                                         "0 1 0 0 0 0 1 0 1 1e7 1 1\ns 0 0 0 0.5\n");
  const std::string junit = folder.path("verdict.xml");
  const ProgramResult compared = runOnDevice(
      {"compare", scene, "--film-scale", "0", "--spp", "4", "--json", "-", "--strict"});
  const ProgramResult verified = runOnDevice(
      {"verify", scene, "--film-scale", "0", "--bias", "5%", "--json", "-", "--junit", junit, "--strict"});
  for (const ProgramResult& result : {compared, verified}) {
    INFO(result.out << result.err);
    REQUIRE(result.exitCode == 3);
    const json report = json::parse(result.out);
    CHECK(report["agrees"] == true);
    CHECK(report["badSamples"]["device"]["samples"] > 0);
    CHECK(report["badSamples"]["device"]["pixels"] == report["badSamples"]["reference"]["pixels"]);
    CHECK(contains(result.err, "device: "));
    CHECK(contains(result.err, "replay: candela explain "));
    CHECK(contains(result.err, "--strict: "));
  }
  const json counts = json::parse(compared.out)["badSamples"];
  CHECK(counts["device"]["samples"] == counts["reference"]["samples"]);
  CHECK(contains(readText(junit), "failures=\"1\""));

  const std::string exr = folder.path("a.exr");
  CHECK(runOnDevice({scene, "-o", exr, "--film-scale", "0", "--spp", "4", "--strict"}).exitCode == 3);
  CHECK(image::badSampleCount(image::readImage(exr)) > 0);
}

TEST_CASE("Ctrl-C during a render on a device writes the finished samples and exits with 7", "[swiftshader-slow]") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const std::string exr = folder.path("a.exr");
  Surroundings surroundings;
  surroundings.interruptAfter = std::chrono::milliseconds(3000);
  const ProgramResult result = runOnDevice({scene, "-o", exr, "--spp", "1000000000"}, surroundings);
  INFO(result.err);
  CHECK(result.exitCode == 7);
  CHECK(image::readImage(exr).width == 16);
}

}  // namespace candela
