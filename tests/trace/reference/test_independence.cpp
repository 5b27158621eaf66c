// The reference shares nothing with the device's tracer but the names of random numbers.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

const fs::path kRoot = CANDELA_SOURCE_DIR;

// The project's own files that a file includes, as paths from the root.
std::vector<std::string> includesOf(const fs::path& file) {
  static const std::regex kInclude(R"(^\s*#\s*include\s*["<]([^">]+)[">])");
  std::vector<std::string> result;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    std::smatch match;
    if (!std::regex_search(line, match, kInclude)) continue;
    for (const fs::path& candidate : {kRoot / match[1].str(), file.parent_path() / match[1].str()}) {
      if (fs::is_regular_file(candidate)) result.push_back(fs::relative(candidate, kRoot).generic_string());
    }
  }
  return result;
}

// All files that the reference's files include, directly or not.
std::set<std::string> closureOfReference() {
  std::set<std::string> seen;
  std::vector<std::string> open;
  for (const auto& entry : fs::directory_iterator(kRoot / "host/trace/reference")) {
    if (entry.path().extension() == ".h" || entry.path().extension() == ".cpp") {
      open.push_back(fs::relative(entry.path(), kRoot).generic_string());
    }
  }
  while (!open.empty()) {
    const std::string file = open.back();
    open.pop_back();
    if (!seen.insert(file).second) continue;
    for (const std::string& include : includesOf(kRoot / file)) open.push_back(include);
  }
  return seen;
}

bool isUnder(const std::string& file, const std::string& folder) { return file.rfind(folder, 0) == 0; }

}  // namespace

TEST_CASE("the reference includes nothing of the shaders but the sample dimensions, and no flattened scene") {
  const std::set<std::string> files = closureOfReference();
  REQUIRE(files.count("host/trace/reference/path.cpp") == 1);
  REQUIRE(files.count("host/scene/scene.h") == 1);
  REQUIRE(files.count("shaders/shared/dimensions.h") == 1);
  for (const std::string& file : files) {
    INFO(file);
    CHECK((!isUnder(file, "shaders/") || file == "shaders/shared/dimensions.h"));
    CHECK_FALSE(isUnder(file, "host/trace/flatten/"));
    CHECK_FALSE(isUnder(file, "host/trace/device/"));
    CHECK_FALSE(isUnder(file, "host/trace/accel/"));
    CHECK_FALSE(isUnder(file, "host/trace/vulkan/"));
  }
}
