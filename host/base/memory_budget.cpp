// Asks the operating system for the memory of the machine and for the limit of the process.
#include "host/base/memory_budget.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "host/base/errors.h"
#include "host/base/memory_limit.h"
#include "host/base/setting_words.h"

namespace candela {
namespace {

std::uint64_t limit = 0;  // 0: none

std::string sizeText(std::uint64_t bytes) {
  constexpr double kMiB = 1024.0 * 1024, kGiB = 1024 * kMiB;
  const auto size = static_cast<double>(bytes);
  return size < kGiB ? fmt::format("{:.0f} MiB", size / kMiB) : fmt::format("{:.1f} GiB", size / kGiB);
}

// A container or a scheduler kills a program that exceeds the limit of its control groups.
std::uint64_t defaultBudget() {
  static const std::uint64_t bytes = std::min(physicalMemory(), controlGroupMemory().value_or(physicalMemory()));
  return bytes;
}

std::string originOfBudget() {
  if (limit > 0) return settingWords("memory") + " allows";
  return defaultBudget() < physicalMemory() ? "the control group of this process allows" : "this machine has";
}

}  // namespace

std::uint64_t physicalMemory() {
  return static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

std::uint64_t memoryBudget() { return limit > 0 ? limit : defaultBudget(); }

void limitMemory(std::uint64_t bytes) { limit = bytes; }

void requireMemory(const std::string& what, std::uint64_t bytes, const std::string& remedy) {
  const std::uint64_t budget = memoryBudget();
  if (bytes <= budget) return;
  throw OutOfMemoryError(
      fmt::format("{} needs about {}; {} {}: {}", what, sizeText(bytes), originOfBudget(), sizeText(budget), remedy));
}

}  // namespace candela
