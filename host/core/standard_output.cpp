// Polls stdout, since a stream does not keep the cause of its failure.
#include "host/core/standard_output.h"

#include <poll.h>
#include <unistd.h>

namespace candela {

bool isStdoutAbandoned() {
  pollfd output{.fd = STDOUT_FILENO, .events = POLLOUT, .revents = 0};
  return ::poll(&output, 1, 0) == 1 && (output.revents & (POLLERR | POLLHUP)) != 0;
}

}  // namespace candela
