// Requests of the window's thread to the engine's.
#pragma once
#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>

#include "host/app/view/engine_view.h"
#include "host/image/image.h"

namespace candela::view {

struct SaveRequest {
  std::filesystem::path file;
  image::DisplayTransform display;
};

struct NewMode {
  Mode mode;
  bool isPaused;
};

/// Among several requests of one kind, only the last one counts.
struct Requests {
  std::optional<scene::Camera> camera;
  std::uint64_t viewSerial = 0;  ///< number of requests for a camera so far
  std::optional<Choice> load;
  bool reads = false;  ///< the file, before `load`
  std::optional<SaveRequest> save;
  std::optional<render::PixelSample> sample;
  bool searches = false;  ///< for the `sample` that differs most
  std::optional<NewMode> mode;

  bool hasAny() const { return camera || load || save || sample || mode; }
};

/// Stores requests until the engine takes them.
class Inbox {
 public:
  /// Changes the requests, and wakes the engine.
  void post(const std::function<void(Requests&)>& change);
  /// Requests that the engine end.
  void end();

  /// Takes all requests, if there are any. With `mayWait`, waits briefly if there are none.
  std::optional<Requests> take(bool mayWait);
  /// True if a request was posted since the last take().
  bool isFull() const { return isFull_; }
  bool isEnded() const { return isEnded_; }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  Requests requests_;
  std::atomic<bool> isFull_{false};
  std::atomic<bool> isEnded_{false};
};

}  // namespace candela::view
