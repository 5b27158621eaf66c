// Asks the operating system for the memory of the machine.
#include "host/core/memory_budget.h"

#include <fmt/format.h>
#include <unistd.h>

#include "host/core/errors.h"

namespace candela {
namespace {

std::uint64_t limit = 0;  // 0: none

std::string sizeText(std::uint64_t bytes) {
  constexpr double kMiB = 1024.0 * 1024, kGiB = 1024 * kMiB;
  const auto size = static_cast<double>(bytes);
  return size < kGiB ? fmt::format("{:.0f} MiB", size / kMiB) : fmt::format("{:.1f} GiB", size / kGiB);
}

}  // namespace

std::uint64_t physicalMemory() {
  return static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

std::uint64_t memoryBudget() { return limit > 0 ? limit : physicalMemory(); }

void limitMemory(std::uint64_t bytes) { limit = bytes; }

void requireMemory(const std::string& what, std::uint64_t bytes, const std::string& remedy) {
  const std::uint64_t budget = memoryBudget();
  if (bytes <= budget) return;
  throw OutOfMemoryError(fmt::format("{} needs about {}; {} {}: {}", what, sizeText(bytes),
                                     limit > 0 ? "--memory allows" : "this machine has", sizeText(budget), remedy));
}

}  // namespace candela
