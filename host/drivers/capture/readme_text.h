// README.md of the folder of a capture.
#pragma once
#include <string>

#include "host/drivers/capture/capture.h"

namespace candela::capture {

std::string readmeText(const Capture& capture);

}  // namespace candela::capture
