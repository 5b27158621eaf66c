// Starts and abandons preparations.
#include "host/app/view/device_preparation.h"

#include <chrono>
#include <utility>

namespace candela::view {
namespace {

bool hasEnded(const std::future<Sessions>& future) {
  return future.valid() && future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

}  // namespace

void DevicePreparation::start(const std::function<Sessions()>& prepare) {
  abandon();
  wanted_ = std::async(std::launch::async, prepare);
}

void DevicePreparation::abandon() {
  if (wanted_.valid()) abandoned_.push_back(std::move(wanted_));
  std::erase_if(abandoned_, hasEnded);
}

bool DevicePreparation::isReady() const { return hasEnded(wanted_); }

}  // namespace candela::view
