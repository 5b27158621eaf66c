"""Opens a report in a real headless Chromium and operates it like a user."""
import array
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

from selenium import webdriver
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.chrome.service import Service

PROGRAM = os.environ["CANDELA_PROGRAM"]
SIDE = 32

# A ball on a floor under a light; `albedo` is that of the floor.
SCENE = """v
from 0 -4 1
at 0 0 0
up 0 0 1
angle 40
hither 1
resolution {side} {side}
b 0.1 0.2 0.3
f 0.8 0.6 0.4 1 0 0 0 0 1 1 1
s 0 0 0 0.5
f {albedo} 1 0 0 0 0 1 1 1
p 4
-3 -3 -0.5
3 -3 -0.5
3 3 -0.5
-3 3 -0.5
f 1 1 1 1 0 0 0 0 1 1 1 4 4 4
s 1 -1 2 0.4
"""


def render(folder, name, albedo, seed):
    """Renders an EXR and a PFM file of one film, and returns the EXR's path."""
    scene = folder / (name + ".p3f")
    scene.write_text(SCENE.format(side=SIDE, albedo=albedo))
    exr = folder / (name + ".exr")
    subprocess.run([PROGRAM, "render", scene, "--device", "cpu", "--spp", "64", "--seed", str(seed), "-q",
                    "-o", exr, "-o", exr.with_suffix(".pfm")], check=True)
    return exr


def pixel_of(pfm, x, y):
    """The binary32 values of one pixel; rows of a PFM file go up."""
    magic, size, scale, data = pfm.read_bytes().split(b"\n", 3)
    width, height = map(int, size.split())
    assert magic == b"PF" and float(scale) < 0 and sys.byteorder == "little"
    values = array.array("f", data)
    first = 3 * ((height - 1 - y) * width + x)
    return list(values[first:first + 3])


def start_browser(profile):
    options = webdriver.ChromeOptions()
    options.binary_location = os.environ["CANDELA_CHROMIUM"]
    for word in ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--window-size=1200,1600",
                 "--force-device-scale-factor=1", "--host-resolver-rules=MAP * ~NOTFOUND", f"--user-data-dir={profile}"):
        options.add_argument(word)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    browser = webdriver.Chrome(service=Service(os.environ["CANDELA_CHROMEDRIVER"]), options=options)
    browser.set_script_timeout(60)
    return browser


class ReportTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="candela-browser-"))
        cls.addClassCleanup(shutil.rmtree, cls.folder, ignore_errors=True)
        cls.a = render(cls.folder, "<b>a&'\"", "0.9 0.3 0.2", 1)  # hostile to HTML, harmless as a file
        cls.b = render(cls.folder, "b", "0.3 0.3 0.9", 2)
        cls.page = cls.folder / "report.html"
        compared = subprocess.run([PROGRAM, "compare", cls.a, cls.b, "--report", cls.page, "-q"])
        assert compared.returncode == 3, "a red floor and a blue one differ"
        cls.browser = start_browser(cls.folder / "profile")
        cls.addClassCleanup(cls.browser.quit)

    def setUp(self):
        self.browser.get("about:blank")
        self.browser.get_log("performance")  # what the browser asked of itself at its start
        self.browser.get(self.page.as_uri())

    def element(self, selector):
        return self.browser.find_element(By.CSS_SELECTOR, selector)

    def wait_for_values(self):
        for _ in range(200):
            if self.values()[0][0]:
                return
        self.fail("no values appeared")

    def values(self):
        """Texts of the read-out: rows red, green, blue, luminance; columns A, B, A - B."""
        return self.browser.execute_script(
            "return [...document.querySelectorAll('#values tr')].map(r => [...r.querySelectorAll('td')].map(c => c.textContent))")

    def colour_at(self, share_x, share_y):
        """The colour on the screen at a position of the pictures, in 0..255."""
        shot = self.element("#side-b .stage").screenshot_as_base64
        return self.browser.execute_async_script(
            "const [shot, x, y, done] = arguments; const image = new Image();"
            "image.onload = () => { const canvas = document.createElement('canvas'); canvas.width = image.width;"
            "canvas.height = image.height; const context = canvas.getContext('2d'); context.drawImage(image, 0, 0);"
            "done([...context.getImageData(x * image.width, y * image.height, 1, 1).data].slice(0, 3)); };"
            "image.src = 'data:image/png;base64,' + shot;", shot, share_x, share_y)

    def point_at(self, selector, x, y):
        """Moves the pointer to the middle of a pixel."""
        stage = self.element(selector)
        self.browser.execute_script("arguments[0].scrollIntoView({block: 'center'})", stage)
        width, height = stage.size["width"], stage.size["height"]
        dx = round((x + 0.5) / SIDE * width - width / 2)
        dy = round((y + 0.5) / SIDE * height - height / 2)
        ActionChains(self.browser, duration=0).move_to_element_with_offset(stage, dx, dy).perform()

    def test_moving_the_divider_changes_what_is_seen(self):
        self.wait_for_values()
        slider = self.element("#split")
        before = self.colour_at(0.3, 0.9)
        self.assertGreater(before[0], before[2] + 30, "left of the divider is A, with the red floor")
        self.assertGreater(self.colour_at(0.7, 0.9)[2], self.colour_at(0.7, 0.9)[0] + 30, "right of it B, with the blue one")
        slider.send_keys(Keys.HOME)
        after = self.colour_at(0.3, 0.9)
        self.assertGreater(after[2], after[0] + 30, "at the left end there is B alone")
        slider.send_keys(Keys.ARROW_RIGHT)
        self.assertEqual(slider.get_attribute("value"), "1")
        slider.send_keys(Keys.END)
        self.assertGreater(self.colour_at(0.95, 0.9)[0], self.colour_at(0.95, 0.9)[2] + 30, "at the right end A alone")

    def test_the_pixel_under_the_pointer_has_the_values_of_the_files(self):
        self.wait_for_values()
        for selector in ("#side-b .stage", ".maps .stage"):
            for x, y in ((3, 28), (17, 5), (31, 31)):
                self.point_at(selector, x, y)
                self.assertEqual(self.element("#place").text, f"x {x}, y {y}")
                a, b = pixel_of(self.a.with_suffix(".pfm"), x, y), pixel_of(self.b.with_suffix(".pfm"), x, y)
                for channel, row in enumerate(self.values()[:3]):
                    shown = array.array("f", [float(row[0]), float(row[1])])
                    self.assertEqual(list(shown), [a[channel], b[channel]])
                    self.assertAlmostEqual(float(row[2]), a[channel] - b[channel], delta=1e-5 * abs(a[channel]) + 1e-7)

    def test_the_arrow_keys_move_the_pixel_and_the_lens(self):
        self.wait_for_values()
        lens = lambda: self.browser.execute_script("return document.getElementById('zoom-a').toDataURL()")
        before = lens()
        pair = self.element("#pair")
        pair.send_keys(Keys.ARROW_LEFT)
        self.assertEqual(self.element("#place").text, f"x {SIDE // 2 - 1}, y {SIDE // 2}")
        pair.send_keys(Keys.SHIFT + Keys.ARROW_DOWN)
        self.assertEqual(self.element("#place").text, f"x {SIDE // 2 - 1}, y {SIDE // 2 + 10}")
        self.assertNotEqual(lens(), before)

    def test_names_of_files_are_text(self):
        self.assertIn(self.a.name, self.element("h1").text)
        self.assertIn(self.a.name, self.element("#side-a figcaption").text)
        self.assertFalse(self.browser.find_elements(By.CSS_SELECTOR, "h1 b"))

    def test_nothing_is_asked_of_the_network_and_nothing_is_logged(self):
        self.wait_for_values()
        self.assertEqual([e for e in self.browser.get_log("browser") if e["level"] in ("SEVERE", "WARNING")], [])
        addresses = set()
        for entry in self.browser.get_log("performance"):
            message = json.loads(entry["message"])["message"]
            if message["method"] == "Network.requestWillBeSent":
                addresses.add(message["params"]["request"]["url"].split(":")[0] + ":")
        self.assertLessEqual(addresses, {"file:", "data:"})
        self.assertIn("file:", addresses)

    def test_without_script_pictures_maps_and_verdict_are_there(self):
        self.browser.execute_cdp_cmd("Emulation.setScriptExecutionDisabled", {"value": True})
        self.addCleanup(self.browser.execute_cdp_cmd, "Emulation.setScriptExecutionDisabled", {"value": False})
        self.browser.get(self.page.as_uri())
        self.assertIn("do NOT show the same light", self.element("#verdict").text)
        pictures = self.browser.find_elements(By.CSS_SELECTOR, "img")
        self.assertEqual(len(pictures), 2 + 2 + 2, "A, B, differences, FLIP, tiles of 8 and 16")
        for picture in pictures:
            self.assertGreater(picture.size["width"], 100)
            self.assertTrue(picture.get_attribute("alt"))
        a, b = (self.element(f"#side-{side} .stage").rect for side in "ab")
        self.assertLess(a["x"] + a["width"], b["x"] + 1, "A and B stand side by side")
        self.assertFalse(self.element("#split").is_displayed())
        self.assertIn("relMSE", self.element("main").text)
        self.assertIn("candela compare", self.element("main").text)


if __name__ == "__main__":
    unittest.main(verbosity=2)
