// The reader of tuning files.
#include "host/measure/tune/tuning_file.h"
#include "tests/fuzz/fuzz.h"

void candela::fuzz::run(Input input) {
  const cache::DeviceKey key{"device", "driver", "1", "uuid", "kernels"};
  vulkan::DeviceInfo info;
  info.maxWorkgroupInvocations = 1024;
  info.maxWorkgroupSize[0] = info.maxWorkgroupSize[1] = info.maxWorkgroupSize[2] = 1024;
  expectErrors([&] { tune::readTuning(fileOf(input), key, info); });
}
