// The memory that the program may use, and the refusal of work that needs more.
#pragma once
#include <cstdint>
#include <string>

namespace candela {

/// Returns the size of the machine's memory in bytes.
std::uint64_t physicalMemory();

/// Returns the memory that the program may use in bytes: what limitMemory() set, else the limit of its control groups
/// at the first call, and at most physicalMemory().
std::uint64_t memoryBudget();
/// Sets the budget of the process (--memory); 0: the default. Call it before other threads are started.
void limitMemory(std::uint64_t bytes);

/// Throws OutOfMemoryError unless `bytes` are within the budget: allocating them could succeed, but would make the
/// machine swap. The message names `what`, which needs them, and `remedy`, a clause.
void requireMemory(const std::string& what, std::uint64_t bytes, const std::string& remedy);

}  // namespace candela
