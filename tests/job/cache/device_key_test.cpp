// Keys of devices and the names of their files.
#include "host/job/cache/device_key.h"

#include <catch2/catch.hpp>
#include <set>

namespace candela::cache {

TEST_CASE("the key contains the properties of the device and the kernels of this program") {
  vulkan::DeviceInfo info;
  info.name = "made device";
  info.driver = "made driver 1.2";
  info.driverVersion = 5;
  info.pipelineCacheUuid = "00ff";
  const DeviceKey key = keyOf(info);
  CHECK(key.device == "made device");
  CHECK(key.driver == "made driver 1.2");
  CHECK(key.driverVersion == "5");
  CHECK(key.pipelineCacheUuid == "00ff");
  CHECK(key.kernels.size() == 64);
  CHECK(key.kernels.find_first_not_of("0123456789abcdef") == std::string::npos);
}

TEST_CASE("the file name differs for every member of the key, and for every kind of file") {
  const DeviceKey key{"a device \"9\"", "a driver 1.2", "17", "0123", "abcd"};
  std::set<std::string> names{fileNameOf("tune", key, "json")};
  CHECK(names.insert(fileNameOf("pipelines", key, "json")).second);
  for (std::string DeviceKey::*member : {&DeviceKey::device, &DeviceKey::driver, &DeviceKey::driverVersion,
                                         &DeviceKey::pipelineCacheUuid, &DeviceKey::kernels}) {
    DeviceKey other = key;
    other.*member += "'";
    CHECK(names.insert(fileNameOf("tune", other, "json")).second);
  }
}

TEST_CASE("the text of a key is one line for any name of a device") {
  DeviceKey key{"caf\xe9\nnewline", "", "", "", ""};
  CHECK(toText(key).find('\n') == std::string::npos);
}

}  // namespace candela::cache
