// Parses CANDELA_FAULT, and counts the calls of each function.
#include "tests/faults/faults.h"

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace candela::faults {
namespace {

constexpr std::array<std::pair<const char*, VkResult>, 19> kResults{
    {{"HANG", kHang},
     {"DROP", kDrop},
     {"DROP_WIDE", kDropWide},
     {"VK_ERROR_OUT_OF_HOST_MEMORY", VK_ERROR_OUT_OF_HOST_MEMORY},
     {"VK_ERROR_OUT_OF_DEVICE_MEMORY", VK_ERROR_OUT_OF_DEVICE_MEMORY},
     {"VK_ERROR_INITIALIZATION_FAILED", VK_ERROR_INITIALIZATION_FAILED},
     {"VK_ERROR_DEVICE_LOST", VK_ERROR_DEVICE_LOST},
     {"VK_ERROR_MEMORY_MAP_FAILED", VK_ERROR_MEMORY_MAP_FAILED},
     {"VK_ERROR_LAYER_NOT_PRESENT", VK_ERROR_LAYER_NOT_PRESENT},
     {"VK_ERROR_EXTENSION_NOT_PRESENT", VK_ERROR_EXTENSION_NOT_PRESENT},
     {"VK_ERROR_FEATURE_NOT_PRESENT", VK_ERROR_FEATURE_NOT_PRESENT},
     {"VK_ERROR_INCOMPATIBLE_DRIVER", VK_ERROR_INCOMPATIBLE_DRIVER},
     {"VK_ERROR_TOO_MANY_OBJECTS", VK_ERROR_TOO_MANY_OBJECTS},
     {"VK_ERROR_FRAGMENTED_POOL", VK_ERROR_FRAGMENTED_POOL},
     {"VK_ERROR_UNKNOWN", VK_ERROR_UNKNOWN},
     {"VK_ERROR_OUT_OF_POOL_MEMORY", VK_ERROR_OUT_OF_POOL_MEMORY},
     {"VK_ERROR_FRAGMENTATION", VK_ERROR_FRAGMENTATION},
     {"VK_TIMEOUT", VK_TIMEOUT},
     {"VK_ERROR_OUT_OF_DATE_KHR", VK_ERROR_OUT_OF_DATE_KHR}}};

struct Fault {
  std::string function;
  unsigned long first = 0;
  bool continues = false;
  VkResult result = VK_SUCCESS;
};

[[noreturn]] void refuse(const std::string& text) {
  std::fprintf(stderr, "CANDELA_FAULT: \"%s\" is not FUNCTION:N:RESULT\n", text.c_str());
  std::abort();
}

Fault parseFault(const std::string& text) {
  std::istringstream words(text);
  std::string number, result;
  Fault fault;
  std::getline(words, fault.function, ':');
  std::getline(words, number, ':');
  std::getline(words, result);
  fault.first = std::strtoul(number.c_str(), nullptr, 10);
  fault.continues = !number.empty() && number.back() == '+';
  const auto* known = std::find_if(kResults.begin(), kResults.end(), [&](auto& r) { return result == r.first; });
  const bool isFunction = std::any_of(kNames.begin(), kNames.end(), [&](auto* n) { return fault.function == n; });
  if (known == kResults.end() || !isFunction || fault.first == 0) refuse(text);
  fault.result = known->second;
  return fault;
}

std::vector<Fault> parseFaults() {
  std::vector<Fault> faults;
  const char* const value = std::getenv("CANDELA_FAULT");
  std::istringstream list(value == nullptr ? "" : value);
  for (std::string text; std::getline(list, text, ',');) faults.push_back(parseFault(text));
  return faults;
}

std::array<std::atomic<unsigned long>, kFunctionCount> calls{};

}  // namespace

std::optional<VkResult> faultOf(Function function) {
  static const std::vector<Fault> faults = parseFaults();
  const unsigned long number = ++calls[function];
  for (const Fault& fault : faults) {
    const bool isDue = fault.continues ? number >= fault.first : number == fault.first;
    if (fault.function != kNames[function] || !isDue) continue;
    if (const char* const log = std::getenv("CANDELA_FAULT_LOG")) {
      std::ofstream(log, std::ios::app) << fault.function << ' ' << number << '\n';
    }
    return fault.result;
  }
  return std::nullopt;
}

void writeCounts() {
  const char* const file = std::getenv("CANDELA_FAULT_COUNTS");
  if (file == nullptr) return;
  std::ofstream output(file);
  for (std::size_t i = 0; i < kFunctionCount; ++i) output << kNames[i] << ' ' << calls[i] << '\n';
}

}  // namespace candela::faults
