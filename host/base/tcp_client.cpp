// Connects to the first of a host's addresses that accepts a connection.
#include "host/base/tcp_client.h"

#include <fmt/format.h>
#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>

#include <cerrno>
#include <memory>
#include <system_error>

#include "host/base/errors.h"

namespace candela {
namespace {

using Addresses = std::unique_ptr<addrinfo, decltype(&freeaddrinfo)>;

Addresses resolve(const ServerAddress& address) {
  addrinfo hints{};
  hints.ai_family = AF_UNSPEC;
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  const int error = getaddrinfo(address.host.c_str(), std::to_string(address.port).c_str(), &hints, &found);
  if (error != 0) throw FileError(fmt::format("{}: {}", addressText(address), gai_strerror(error)));
  return {found, &freeaddrinfo};
}

// Returns 0 once the socket can be written to, or else an error number.
int waitToWrite(int socket) {
  pollfd wanted{socket, POLLOUT, 0};
  const int ready = poll(&wanted, 1, TcpClient::kTimeoutSeconds * 1000);
  if (ready < 0 && errno == EINTR) return 0;  // the next call waits again
  if (ready <= 0) return ready < 0 ? errno : ETIMEDOUT;
  return 0;
}

// Returns 0 or an error number. The socket does not block.
int connectTo(const addrinfo& target, FileDescriptor& socket) {
  socket = FileDescriptor(
      ::socket(target.ai_family, target.ai_socktype | SOCK_NONBLOCK | SOCK_CLOEXEC, target.ai_protocol));
  if (!socket.isOpen()) return errno;
  if (::connect(socket.get(), target.ai_addr, target.ai_addrlen) == 0) return 0;
  if (errno != EINPROGRESS) return errno;
  if (const int error = waitToWrite(socket.get()); error != 0) return error;
  int error = 0;
  socklen_t size = sizeof error;
  return getsockopt(socket.get(), SOL_SOCKET, SO_ERROR, &error, &size) == 0 ? error : errno;
}

}  // namespace

std::string addressText(const ServerAddress& address) {
  const bool hasColons = address.host.find(':') != std::string::npos;
  return hasColons ? fmt::format("[{}]:{}", address.host, address.port)
                   : fmt::format("{}:{}", address.host, address.port);
}

TcpClient::TcpClient(const ServerAddress& address) : address_(address) {
  const Addresses addresses = resolve(address);
  int error = 0;
  for (const addrinfo* target = addresses.get(); target != nullptr; target = target->ai_next) {
    error = connectTo(*target, socket_);
    if (error == 0) return;
  }
  fail(error);
}

void TcpClient::send(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::send(socket_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (count > 0) {
      bytes = bytes.subspan(static_cast<std::size_t>(count));
    } else if (errno == EAGAIN || errno == EWOULDBLOCK) {
      if (const int error = waitToWrite(socket_.get()); error != 0) fail(error);
    } else if (errno != EINTR) {
      fail(errno);
    }
  }
}

void TcpClient::fail(int error) const {
  throw FileError(fmt::format("{}: {}", addressText(address_), std::generic_category().message(error)));
}

}  // namespace candela
