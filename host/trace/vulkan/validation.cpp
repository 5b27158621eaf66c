// The log of the validation layer's messages, one per process.
#include "host/trace/vulkan/validation.h"

#include <cstdlib>
#include <mutex>

#include "host/trace/vulkan/validation_log.h"

namespace candela::vulkan {
namespace {

struct Log {
  std::mutex mutex;
  std::vector<std::string> messages;
};

Log& log() {
  static Log instance;
  return instance;
}

}  // namespace

bool validationRequested() {
  const char* value = std::getenv("CANDELA_VALIDATION");
  return value != nullptr && *value != '\0' && std::string(value) != "0";
}

void addValidationMessage(const std::string& message) {
  const std::lock_guard lock(log().mutex);
  log().messages.push_back(message);
}

std::vector<std::string> validationMessages() {
  const std::lock_guard lock(log().mutex);
  return log().messages;
}

void clearValidationMessages() {
  const std::lock_guard lock(log().mutex);
  log().messages.clear();
}

}  // namespace candela::vulkan
