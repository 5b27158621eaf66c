// The type of buffer from which a device reads records faster.
#pragma once
#include <cstdint>

namespace candela::vulkan {

class Device;

/// Seconds that a device takes to read the same records at random, as a traversal does: the shortest of several runs.
struct LoadTimes {
  double texel = 0;
  double storage = 0;
};

/// Runs a small kernel on each type of buffer, alternately. A device in software takes 25 to 40 ms, and about 100 ms if
/// its driver has not compiled the kernel before. Throws as Device::run().
LoadTimes probeLoads(Device& device);

}  // namespace candela::vulkan
