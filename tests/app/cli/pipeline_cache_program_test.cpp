// Compiled pipelines in the cache folder: when they are stored, used, ignored and replaced.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>

#include "host/job/cache/pipeline_file.h"
#include "host/trace/vulkan/device_info.h"
#include "tests/app/cli/run_program.h"

namespace candela {
namespace {

using Catch::Contains;

class Cache {
 public:
  Cache() : scene_(folder_.write("a.p3f", smallScene())) {
    const char* const device = std::getenv("CANDELA_TEST_DEVICE");
    selector_ = device == nullptr ? "" : device;
    key_ = cache::keyOf(vulkan::selectDevice(selector_));
    file_ = folder_.path("cache/" + cache::fileNameOf("pipelines", key_, "bin"));
  }

  ProgramResult render(std::vector<std::string> options = {}) const {
    std::vector<std::string> words{scene_, "--spp", "1", "--verbose", "--json", "-"};
    if (!selector_.empty()) words.insert(words.end(), {"--device", selector_});
    words.insert(words.end(), options.begin(), options.end());
    return runCandela(words, {{"CANDELA_CACHE_DIR=" + folder_.path("cache")}, {}, {}});
  }

  bool isStored() const { return std::filesystem::exists(file_); }
  void damage() const { std::ofstream(file_, std::ios::app) << "more"; }
  void removeFolder() const { folder_.write("cache", ""); }
  cache::PipelineLookup stored() const { return cache::readPipelines(file_, key_); }

 private:
  TemporaryFolder folder_;
  std::string scene_;
  std::string selector_;
  cache::DeviceKey key_;
  std::string file_;
};

}  // namespace

TEST_CASE("a render stores its compiled pipelines, and the next one loads them") {
  const Cache cache;
  const ProgramResult first = cache.render();
  REQUIRE(first.exitCode == 0);
  CHECK_THAT(first.err, Contains(" bytes to "));
  REQUIRE(cache.isStored());
  CHECK(cache.stored().problem.empty());
  const ProgramResult second = cache.render();
  REQUIRE(second.exitCode == 0);
  CHECK_THAT(second.err, Contains(" bytes from "));
}

TEST_CASE("a damaged file of compiled pipelines is ignored and replaced", "[swiftshader-slow]") {
  const Cache cache;
  REQUIRE(cache.render().exitCode == 0);
  REQUIRE(cache.isStored());
  cache.damage();
  const ProgramResult result = cache.render();
  REQUIRE(result.exitCode == 0);
  CHECK_THAT(result.err, Contains("is ignored: it is damaged"));
  CHECK(cache.stored().problem.empty());
}

TEST_CASE("the option --no-cache stores no compiled pipelines") {
  const Cache cache;
  const ProgramResult result = cache.render({"--no-cache"});
  REQUIRE(result.exitCode == 0);
  CHECK_FALSE(cache.isStored());
}

TEST_CASE("a render succeeds if compiled pipelines cannot be stored") {
  const Cache cache;
  cache.removeFolder();  // replaced by a file of that name
  const ProgramResult result = cache.render();
  REQUIRE(result.exitCode == 0);
  CHECK_THAT(result.err, Contains("compiled pipelines are not stored: "));
}

}  // namespace candela
