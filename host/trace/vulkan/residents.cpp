// Keeps objects alive through a pointer that is never freed.
#include "host/trace/vulkan/residents.h"

#include <atomic>

#include "host/trace/vulkan/unfinished_work.h"

namespace candela::vulkan {
namespace {

std::atomic<bool> unfinished{false};

}  // namespace

void Residents::add(const std::shared_ptr<void>& object) {
  const std::scoped_lock lock(mutex_);
  if (objects_.size() == objects_.capacity()) {
    std::erase_if(objects_, [](const std::weak_ptr<void>& other) { return other.expired(); });
  }
  objects_.push_back(object);
}

void Residents::keepAll() {
  static auto& kept = *new std::vector<std::shared_ptr<void>>;
  const std::scoped_lock lock(mutex_);
  for (const std::weak_ptr<void>& object : objects_) {
    if (std::shared_ptr<void> alive = object.lock()) kept.push_back(std::move(alive));
  }
  objects_.clear();
  unfinished = true;
}

bool hasUnfinishedWork() { return unfinished; }

}  // namespace candela::vulkan
