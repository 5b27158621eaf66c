// A TCP connection that sends.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "host/base/file_descriptor.h"

namespace candela {

/// A host, by name or number, and a TCP port.
struct ServerAddress {
  std::string host;
  std::uint16_t port = 0;

  bool operator==(const ServerAddress&) const = default;
};

/// Returns "HOST:PORT", with brackets around a host that has colons.
std::string addressText(const ServerAddress& address);

/// Throws FileError, which names the address, where the server cannot be reached, has closed the connection, or takes
/// nothing for kTimeoutSeconds.
class TcpClient {
 public:
  static constexpr int kTimeoutSeconds = 5;

  /// Connects.
  explicit TcpClient(const ServerAddress& address);

  /// Sends all bytes.
  void send(std::span<const std::byte> bytes);

 private:
  [[noreturn]] void fail(int error) const;

  ServerAddress address_;
  FileDescriptor socket_{-1};
};

}  // namespace candela
