// Shows a render in a display server while it is computed: --display-server.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "host/base/log.h"
#include "host/base/tcp_client.h"
#include "host/image/image.h"

namespace candela::cli {

/// Streams the channels of an image to tev. A server that cannot be reached, or fails later, is a warning: the render
/// continues without it.
class DisplayStream {
 public:
  /// Connects. `name` is that of the image in the viewer. `log` outlives the object.
  DisplayStream(const ServerAddress& address, std::string name, const Log& log);

  /// Sends the tiles that changed since the last call; all images must have the size and the channels of the first.
  void show(const image::Image& image);

 private:
  void send(const image::Image& image);

  std::string name_;
  const Log& log_;
  std::optional<TcpClient> server_;  ///< empty: it failed
  std::vector<float> shown_;         ///< the channels of each pixel side by side, as last sent
};

}  // namespace candela::cli
