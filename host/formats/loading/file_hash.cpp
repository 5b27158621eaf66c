// Chooses the thread that computes a hash.
#include "host/formats/loading/file_hash.h"

#include "host/base/hash.h"

namespace candela::scene {

std::shared_future<std::uint64_t> startHash(std::string_view bytes) {
  constexpr std::size_t kLarge = std::size_t{1} << 20;
  const auto policy = bytes.size() < kLarge ? std::launch::deferred : std::launch::async;
  return std::async(policy, [bytes] { return fnv1aOfText(bytes); }).share();
}

}  // namespace candela::scene
