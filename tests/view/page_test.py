#!/usr/bin/env python3
"""The page of `autoref play --view` in a real browser: page_test.py AUTOREF SCENARIO.

Needs Debian's chromium, chromium-driver and python3-selenium. With AUTOREF_SCREENSHOTS=FOLDER it
leaves pictures there.
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import WebDriverWait

WAIT_S = 20
YELLOW, BLUE, BALL = (255, 212, 59), (74, 157, 255), (255, 123, 28)
PHONE, DESKTOP, PROJECTOR = (390, 844), (1280, 800), (1920, 1080)

COUNT_PIXELS = """
const [red, green, blue] = arguments[0];
const canvas = document.querySelector("canvas");
const {data} = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
let count = 0;
for (let i = 0; i < data.length; i += 4) {
  const far = Math.abs(data[i] - red) + Math.abs(data[i + 1] - green) + Math.abs(data[i + 2] - blue);
  if (far < 12) ++count;
}
return count;
"""
COUNT_FRAMES = """
const done = arguments[0];
const begin = performance.now();
let frames = 0;
const next = (now) => {
  if (now - begin > 1500) return done(1000 * frames / (now - begin));
  ++frames;
  requestAnimationFrame(next);
};
requestAnimationFrame(next);
"""


def played_game(autoref, scenario, page):
    """The record of a game in which cobalt scores now and then, its page being written."""
    done = subprocess.run(
        [autoref, "play", scenario, "--json", "--view", page, "--set", "a.strategy=cobalt",
         "--set", "b.strategy=chaser", "--set", "match.half_s=120"],
        check=True, capture_output=True, text=True, timeout=120)
    return json.loads(done.stdout)


def start_browser():
    options = Options()
    options.binary_location = shutil.which("chromium")
    for argument in ("--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--hide-scrollbars"):
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    browser = webdriver.Chrome(service=Service(shutil.which("chromedriver")), options=options)
    browser.set_page_load_timeout(60)
    browser.set_script_timeout(30)
    return browser


class PageTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.page = pathlib.Path(cls.folder.name) / "game.html"
        cls.record = played_game(AUTOREF, SCENARIO, str(cls.page))
        cls.browser = start_browser()
        cls.addClassCleanup(cls.browser.quit)

    def setUp(self):
        self.show(DESKTOP)
        self.browser.get(self.page.as_uri())

    def show(self, size):
        width, height = size
        self.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
            "width": width, "height": height, "deviceScaleFactor": 1, "mobile": size == PHONE})

    def press(self, keys):
        self.browser.find_element(By.TAG_NAME, "body").send_keys(keys)
        self.settle()

    def settle(self):
        """Waits until what was asked for has been drawn."""
        self.browser.execute_async_script(
            "const done = arguments[0]; requestAnimationFrame(() => requestAnimationFrame(() => done()));")

    def text(self, name):
        return self.browser.find_element(By.ID, name).get_attribute("textContent")

    def time_s(self):
        minutes, seconds = self.text("time").split(":")
        return 60 * int(minutes) + float(seconds)

    def score(self):
        return [int(self.text("goals0")), int(self.text("goals1"))]

    def pixels(self, color):
        return self.browser.execute_script(COUNT_PIXELS, list(color))

    def wait_until(self, condition):
        WebDriverWait(self.browser, WAIT_S, 0.05).until(lambda _: condition())

    def leave_picture(self, name):
        folder = os.environ.get("AUTOREF_SCREENSHOTS")
        if folder:
            self.browser.save_screenshot(str(pathlib.Path(folder) / f"{name}.png"))

    def test_loads_without_complaints(self):
        self.assertEqual(self.browser.get_log("browser"), [])

    def test_asks_no_network_for_anything(self):
        messages = [json.loads(entry["message"])["message"] for entry in self.browser.get_log("performance")]
        addresses = [message["params"]["request"]["url"] for message in messages
                     if message["method"] == "Network.requestWillBeSent"]
        self.assertIn(self.page.as_uri(), addresses)
        self.assertEqual([one for one in addresses if not one.startswith(("file:", "data:"))], [])

    def test_shows_both_teams_and_the_ball(self):
        self.assertEqual([self.text("team0"), self.text("team1")], ["cobalt", "chaser"])
        for color in (YELLOW, BLUE, BALL):
            self.assertGreater(self.pixels(color), 10)

    def test_plays_and_pauses_by_the_space_bar(self):
        self.press(" ")
        self.wait_until(lambda: self.time_s() > 0.3)
        self.press(" ")
        stands_at_s = self.time_s()
        print(f"{self.browser.execute_async_script(COUNT_FRAMES):.0f} frames a second while it stands")
        self.assertEqual(self.time_s(), stands_at_s)

    def test_moves_many_frames_a_second(self):
        self.press("+ ")
        frames = self.browser.execute_async_script(COUNT_FRAMES)
        print(f"{frames:.0f} frames a second while it plays")
        self.assertGreater(frames, 0.5)  # of a busy machine without a graphics card

    def test_steps_by_one_picture(self):
        self.press("....")
        self.assertAlmostEqual(self.time_s(), 4 / 60, delta=0.006)
        self.press(",")
        self.assertAlmostEqual(self.time_s(), 3 / 60, delta=0.006)

    def test_shows_the_recorded_score_at_each_goal(self):
        goals = self.record["goals_a"] + self.record["goals_b"]
        self.assertGreater(goals, 0)
        for goal in range(1, goals + 1):
            self.press("g")
            self.assertEqual(sum(self.score()), goal)
            self.assertTrue(self.text("callTitle").find("Goal for") > 0)
        self.assertEqual(self.score(), [self.record["goals_a"], self.record["goals_b"]])

    def test_comes_back_to_a_goal_by_steps(self):
        self.press("g")
        self.press("," * 5)
        self.assertEqual(sum(self.score()), 0)
        self.press("." * 5)
        self.assertEqual(sum(self.score()), 1)

    def test_goes_to_a_goal_by_its_mark(self):
        marks = self.browser.find_elements(By.CSS_SELECTOR, ".mark.goal")
        self.assertEqual(len(marks), self.record["goals_a"] + self.record["goals_b"])
        marks[-1].click()
        self.settle()
        self.assertEqual(self.score(), [self.record["goals_a"], self.record["goals_b"]])
        self.leave_picture("desktop")

    def test_goes_where_the_time_line_is_pointed_at(self):
        line = self.browser.find_element(By.ID, "timeline")
        webdriver.ActionChains(self.browser).move_to_element_with_offset(
            line, 0, line.size["height"] // 2 - 4).click().perform()
        self.settle()
        minutes, seconds = self.text("length").split(":")
        self.assertAlmostEqual(self.time_s(), (60 * int(minutes) + int(seconds)) / 2, delta=2)

    def test_tells_why_the_referee_stopped_play(self):
        stops = self.browser.find_elements(By.CSS_SELECTOR, ".highlight.stop .reason")
        self.assertGreater(len(stops), 0)
        self.press("n")
        self.assertNotEqual(self.text("callReason"), "")

    def test_draws_each_layer(self):
        self.press("gg" + Keys.ARROW_LEFT)
        for key in "1234":
            before = self.browser.execute_script("return document.querySelector('canvas').toDataURL()")
            self.press(key)
            after = self.browser.execute_script("return document.querySelector('canvas').toDataURL()")
            # Distances are watched only at restarts.
            if key != "3":
                self.assertNotEqual(before, after, f"layer {key}")

    def test_opens_and_closes_help(self):
        is_open = lambda: self.browser.execute_script("return document.getElementById('help').open")
        self.press("?")
        self.assertTrue(is_open())
        self.press(Keys.ESCAPE)
        self.wait_until(lambda: not is_open())

    def test_fits_a_phone_and_a_projector(self):
        for size, name in ((PHONE, "phone"), (PROJECTOR, "projector")):
            self.show(size)
            self.settle()
            width = self.browser.execute_script("return document.documentElement.scrollWidth")
            self.assertLessEqual(width, size[0])
            self.leave_picture(name)
        self.assertLessEqual(
            self.browser.execute_script("return document.documentElement.scrollHeight"), PROJECTOR[1])


if __name__ == "__main__":
    SCENARIO, AUTOREF = sys.argv.pop(), sys.argv.pop()
    unittest.main(verbosity=2)
