"""The list of devices is that of the program."""
import json
import os
import unittest

import candela
from support import run


class Devices(unittest.TestCase):
    def test_devices_are_those_of_the_program(self):
        devices = candela.devices()
        self.assertEqual(devices, json.loads(run("devices", "--json", "-").stdout)["devices"])
        self.assertIn("llvmpipe", devices[0]["name"])
        self.assertEqual([device["index"] for device in devices if device["default"]], [0])

    def test_no_device_is_an_error(self):
        drivers = {name: os.environ.pop(name, None) for name in ("VK_DRIVER_FILES", "VK_ICD_FILENAMES")}
        self.addCleanup(os.environ.update, {name: value for name, value in drivers.items() if value})
        os.environ["VK_DRIVER_FILES"] = os.environ["VK_ICD_FILENAMES"] = "/nonexistent.json"
        with self.assertRaisesRegex(candela.NoDeviceError, "no Vulkan device found"):
            candela.devices()


if __name__ == "__main__":
    unittest.main()
