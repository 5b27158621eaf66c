// The file that stores a choice: its key, and its behaviour if it is changed or damaged.
#include "host/measure/tune/tuning_file.h"

#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <functional>
#include <nlohmann/json.hpp>

#include "host/base/errors.h"
#include "tests/base/temporary_folder.h"
#include "tests/measure/tune/made_rows.h"

namespace candela::tune {
namespace {

using nlohmann::ordered_json;

const cache::DeviceKey kKey{"a device \"9\"", "a driver 1.2", "17", "0123", "abcd"};
const std::string kDate = "2026-01-31T12:00:00Z";

Candidate someChoice() { return candidateWith({{"layout", "bvh2"}, {"loads", "storage"}, {"workgroup", "16x16"}}); }

// Returns the text of a valid file.
std::string soundText() {
  const TemporaryFolder folder;
  writeTuning(folder / "a.json", kKey, {someChoice(), kDate});
  return readText(folder / "a.json");
}

// Returns the result of reading a file with this content.
TuningLookup lookUp(const std::string& text) {
  const TemporaryFolder folder;
  writeText(folder / "a.json", text);
  return readTuning(folder / "a.json", kKey, roomyDevice());
}

std::string changed(const std::function<void(ordered_json&)>& change) {
  ordered_json json = ordered_json::parse(soundText());
  change(json);
  return json.dump();
}

TEST_CASE("a choice is read as it was written, from a folder that was created for it") {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "new" / "folder" / cache::fileNameOf("tune", kKey, "json");
  writeTuning(file, kKey, {builtIn(), kDate});
  writeTuning(file, kKey, {someChoice(), kDate});
  const TuningLookup found = readTuning(file, kKey, roomyDevice());
  CHECK(found.problem.empty());
  REQUIRE(found.tuning);
  CHECK(found.tuning->candidate == someChoice());
  CHECK(found.tuning->date == kDate);
  CHECK(std::distance(std::filesystem::directory_iterator(file.parent_path()), {}) == 1);
}

TEST_CASE("without a tuning file there is no choice and no problem") {
  const TemporaryFolder folder;
  for (const auto& file : {folder / "none.json", folder.path() / "no folder" / "none.json"}) {
    const TuningLookup found = readTuning(file, kKey, roomyDevice());
    CHECK_FALSE(found.tuning);
    CHECK(found.problem.empty());
  }
}

TEST_CASE("a file of another device, driver or set of kernels is refused") {
  const TemporaryFolder folder;
  for (std::string cache::DeviceKey::*field :
       {&cache::DeviceKey::device, &cache::DeviceKey::driver, &cache::DeviceKey::driverVersion,
        &cache::DeviceKey::pipelineCacheUuid, &cache::DeviceKey::kernels}) {
    cache::DeviceKey other = kKey;
    other.*field += "'";
    writeTuning(folder / "a.json", kKey, {someChoice(), kDate});
    const TuningLookup found = readTuning(folder / "a.json", other, roomyDevice());
    CHECK_FALSE(found.tuning);
    CHECK_THAT(found.problem, Catch::Contains("another device, driver or set of kernels"));
  }
}

TEST_CASE("the order of the fields in a file does not matter") {
  CHECK(lookUp(nlohmann::json::parse(soundText()).dump()).tuning);
}

TEST_CASE("names of devices that are not UTF-8 are stored, too") {
  const TemporaryFolder folder;
  cache::DeviceKey key = kKey;
  key.device = "caf\xe9";
  writeTuning(folder / "a.json", key, {someChoice(), kDate});
  CHECK(readTuning(folder / "a.json", key, roomyDevice()).tuning);
}

TEST_CASE("a file that is truncated at any position is ignored and reported as damaged") {
  const std::string text = soundText();
  REQUIRE(lookUp(text).tuning);
  for (std::size_t size = 0; size + 2 <= text.size(); ++size) {
    const TuningLookup found = lookUp(text.substr(0, size));
    REQUIRE_FALSE(found.tuning);
    REQUIRE(found.problem == "it is damaged");
  }
}

TEST_CASE("a file with any byte changed gives a valid choice, or none and a reason") {
  const std::string text = soundText();
  for (std::size_t i = 0; i < text.size(); ++i) {
    for (const char byte : {'\0', '0', '"', '}', '\xff'}) {
      std::string other = text;
      other[i] = byte;
      const TuningLookup found = lookUp(other);
      REQUIRE(found.tuning.has_value() == found.problem.empty());
      if (found.tuning) REQUIRE(isFeasible(found.tuning->candidate, roomyDevice()));
    }
  }
}

TEST_CASE("hostile content is ignored with a reason") {
  const std::string escape = "\x1b[31m";
  const std::vector<std::string> texts{
      "null",
      "[]",
      "7",
      "\"candela-tune/1\"",
      "{}",
      "\xff\xfe\x00",
      std::string(60000, '['),
      std::string(60000, ' '),
      "{\"schema\":\"candela-tune/1\",\"key\":" + std::string(30000, '[') + std::string(30000, ']') + "}",
      changed(
          [](ordered_json& json) { json["key"] = ordered_json::parse(std::string(300, '[') + std::string(300, ']')); }),
      changed([](ordered_json& json) { json["schema"] = "candela-tune/2"; }),
      changed([](ordered_json& json) { json["schema"] = 1; }),
      changed([](ordered_json& json) { json.erase("key"); }),
      changed([](ordered_json& json) { json["key"]["more"] = ""; }),
      changed([](ordered_json& json) { json.erase("choice"); }),
      changed([](ordered_json& json) {
        json["choice"] = {"bvh2", "storage", "8x8"};
      }),
      changed([](ordered_json& json) { json["choice"].erase("loads"); }),
      changed([](ordered_json& json) { json["choice"]["more"] = "x"; }),
      changed([](ordered_json& json) { json["choice"]["layout"] = "auto"; }),
      changed([](ordered_json& json) { json["choice"]["layout"] = 1; }),
      changed([](ordered_json& json) { json["choice"]["workgroup"] = "0x0"; }),
      changed([](ordered_json& json) { json["choice"]["workgroup"] = "4294967295x4294967295"; }),
      changed([&](ordered_json& json) { json["choice"]["workgroup"] = escape; }),
      changed([&](ordered_json& json) { json["date"] = escape + "31T12:00:00Z"; }),
      changed([&](ordered_json& json) { json["date"] = kDate + kDate; }),
      changed([](ordered_json& json) { json["date"] = 7; })};
  for (const std::string& text : texts) {
    const TuningLookup found = lookUp(text);
    INFO(text.substr(0, 200));
    CHECK_FALSE(found.tuning);
    CHECK_FALSE(found.problem.empty());
    CHECK(found.problem.find('\x1b') == std::string::npos);
  }
}

TEST_CASE("a file that is too large for a tuning result is not read completely") {
  CHECK(lookUp(soundText() + std::string(1 << 16, ' ')).problem == "too large");
}

TEST_CASE("folders, pipes and devices instead of the file are ignored without waiting") {
  const TemporaryFolder folder;
  REQUIRE(::mkfifo((folder / "pipe").c_str(), 0600) == 0);
  for (const std::filesystem::path& file : {folder.path(), folder / "pipe", std::filesystem::path("/dev/zero")}) {
    const TuningLookup found = readTuning(file, kKey, roomyDevice());
    CHECK_FALSE(found.tuning);
    CHECK(found.problem == "not a regular file");
  }
}

TEST_CASE("a workgroup that the device does not have is ignored") {
  const TemporaryFolder folder;
  writeTuning(folder / "a.json", kKey, {someChoice(), kDate});
  vulkan::DeviceInfo small = roomyDevice();
  small.maxWorkgroupInvocations = 128;
  const TuningLookup found = readTuning(folder / "a.json", kKey, small);
  CHECK_FALSE(found.tuning);
  CHECK(found.problem == "the device does not support its settings");
}

TEST_CASE("a file that cannot be written is refused, both in advance and when it is written") {
  const TemporaryFolder folder;
  writeText(folder / "file", "");
  const std::filesystem::path inFile = folder.path() / "file" / "cache";
  CHECK_THROWS_AS(requireTuningFile(inFile / "a.json"), FileError);
  CHECK_THROWS_AS(writeTuning(inFile / "a.json", kKey, {builtIn(), kDate}), FileError);
  REQUIRE(::mkfifo((folder / "pipe").c_str(), 0600) == 0);
  CHECK_THROWS_AS(requireTuningFile(folder / "pipe"), FileError);
  CHECK_THROWS_AS(requireTuningFile(folder.path()), FileError);
  CHECK_NOTHROW(requireTuningFile(folder / "file"));
  CHECK_NOTHROW(requireTuningFile(folder.path() / "not" / "yet" / "a.json"));
  CHECK_FALSE(std::filesystem::exists(folder / "not"));
}

TEST_CASE("the current time is written in the notation that is read") {
  const TemporaryFolder folder;
  writeTuning(folder / "a.json", kKey, {builtIn(), dateNow()});
  CHECK(readTuning(folder / "a.json", kKey, roomyDevice()).tuning);
}

}  // namespace
}  // namespace candela::tune
