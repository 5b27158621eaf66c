// Polls stdout, since a stream does not keep the cause of its failure.
#include "host/base/standard_output.h"

#include <poll.h>
#include <unistd.h>

#include <iostream>

namespace candela {

void writeStandardOutput(std::span<const std::byte> bytes) {
  const auto size = static_cast<std::streamsize>(bytes.size());
  if (!std::cout.write(reinterpret_cast<const char*>(bytes.data()), size).flush()) throw StdoutError();
}

bool isStdoutAbandoned() {
  pollfd output{.fd = STDOUT_FILENO, .events = POLLOUT, .revents = 0};
  return ::poll(&output, 1, 0) == 1 && (output.revents & (POLLERR | POLLHUP)) != 0;
}

}  // namespace candela
