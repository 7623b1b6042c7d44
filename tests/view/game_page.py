"""Shared code for tests of the page that shows a game."""
import csv
import json
import pathlib
import subprocess
import tempfile
import unittest

from browser import DESKTOP, BrowserTest
from selenium.webdriver.common.by import By

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


def played_game(autoref, scenario, page, log=None, chains=None, actions=None, **settings):
    """Plays a game, writes its page and, if asked for, its log, possession chains and actions; returns its record."""
    chosen = [word for key, value in settings.items() for word in ("--set", f"{key.replace('__', '.')}={value}")]
    outputs = (("--log", log), ("--chains", chains), ("--actions", actions))
    files = [word for flag, file in outputs if file for word in (flag, file)]
    done = subprocess.run(
        [autoref, "play", scenario, "--json", "--view", page, *chosen, *files],
        check=True,
        capture_output=True,
        text=True,
        timeout=300,
    )
    return json.loads(done.stdout)


class GamePage(BrowserTest):
    """The page of a game played with the settings of the class."""

    autoref, scenario = "", ""  # the program and a game file
    settings = {}

    @classmethod
    def setUpClass(cls):
        if cls is GamePage:
            raise unittest.SkipTest("has no tests of its own")
        super().setUpClass()
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.page = pathlib.Path(cls.folder.name) / "game.html"
        tables = {name: pathlib.Path(cls.folder.name) / f"{name}.csv" for name in ("chains", "actions")}
        files = {name: str(file) for name, file in tables.items()}
        cls.record = played_game(cls.autoref, cls.scenario, str(cls.page), **files, **cls.settings)
        for name, file in tables.items():
            with file.open(newline="") as rows:
                setattr(cls, name, list(csv.DictReader(rows)))  # as `play --chains` and `--actions` write them

    def setUp(self):
        self.show(DESKTOP)
        self.browser.get(self.page.as_uri())

    def press(self, keys):
        self.browser.find_element(By.TAG_NAME, "body").send_keys(keys)
        self.settle()

    def time_s(self):
        minutes, seconds = self.text("time").split(":")
        return 60 * int(minutes) + float(seconds)

    def score(self):
        return [int(self.text("goals0")), int(self.text("goals1"))]

    def pixels(self, color):
        return self.browser.execute_script(COUNT_PIXELS, list(color))
