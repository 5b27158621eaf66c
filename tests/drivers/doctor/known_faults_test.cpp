// The table of known faults: its devices, and its evidence.
#include "host/drivers/doctor/known_faults.h"

#include <catch2/catch.hpp>
#include <cctype>
#include <set>

#include "tests/base/temporary_folder.h"

namespace candela::doctor {
namespace {

// The anchors that GitHub makes of the headings of a page: lower case, without punctuation, with hyphens for spaces.
std::set<std::string> anchorsOf(const std::string& page) {
  std::set<std::string> anchors;
  std::istringstream lines(page);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("## ")) continue;
    std::string anchor;
    for (const char c : line.substr(3)) {
      const auto byte = static_cast<unsigned char>(c);
      if (std::isalnum(byte) || c == '-') anchor += static_cast<char>(std::tolower(byte));
      if (c == ' ') anchor += '-';
    }
    anchors.insert(anchor);
  }
  return anchors;
}

}  // namespace

TEST_CASE("the evidence of every known fault is a heading of a page") {
  REQUIRE_FALSE(knownFaults().empty());
  for (const KnownFault& fault : knownFaults()) {
    const std::string evidence(fault.evidence);
    INFO(evidence);
    const std::size_t hash = evidence.find('#');
    REQUIRE(hash != std::string::npos);
    const std::string page = readText(CANDELA_SOURCE_DIR "/" + evidence.substr(0, hash));
    CHECK(anchorsOf(page).contains(evidence.substr(hash + 1)));
  }
}

TEST_CASE("a device has only the faults of its driver") {
  vulkan::DeviceInfo device;
  device.name = "llvmpipe (LLVM 15.0.6, 256 bits)";
  const Checks lavapipe = checkKnownFaults(device);
  REQUIRE_FALSE(lavapipe.empty());
  CHECK_THAT(lavapipe[0].text, Catch::Contains("65,535 iterations"));
  for (const Check& check : lavapipe) CHECK(check.text.starts_with("llvmpipe "));
  device.name = "SwiftShader Device (LLVM 16.0.0)";
  for (const Check& check : checkKnownFaults(device)) CHECK(check.text.starts_with("swiftshader "));
  device.name = "NVIDIA GeForce RTX 3060";
  device.driver = "NVIDIA 550.54";
  CHECK(checkKnownFaults(device).empty());
}

}  // namespace candela::doctor
