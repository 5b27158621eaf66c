// Hands requests from thread to thread.
#include "host/app/view/requests.h"

#include <chrono>
#include <utility>

namespace candela::view {
namespace {

constexpr std::chrono::milliseconds kIdle{50};

}  // namespace

void Inbox::post(const std::function<void(Requests&)>& change) {
  {
    const std::scoped_lock lock(mutex_);
    change(requests_);
    isFull_ = true;
  }
  changed_.notify_one();
}

void Inbox::end() {
  post([this](Requests&) { isEnded_ = true; });
}

std::optional<Requests> Inbox::take(bool mayWait) {
  std::unique_lock lock(mutex_);
  if (mayWait) changed_.wait_for(lock, kIdle, [this] { return requests_.hasAny() || isEnded_; });
  isFull_ = false;
  if (!requests_.hasAny()) return std::nullopt;
  Requests taken = std::exchange(requests_, {});
  requests_.viewSerial = taken.viewSerial;
  return taken;
}

}  // namespace candela::view
