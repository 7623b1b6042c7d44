"""Debian's headless chromium, for testing pages."""
import json
import os
import pathlib
import shutil
import unittest

from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.by import By
from selenium.webdriver.support.ui import WebDriverWait

WAIT_S = 120
PHONE, DESKTOP, PROJECTOR = (390, 844), (1280, 800), (1920, 1080)
PAPER = (718, 1040)  # A4 without margins, at 96 dpi

# Elements that extend beyond the page and are not inside a scrollable box.
CUT_OFF = """
const scrolls = (element) => element && element !== document.body &&
  (["auto", "scroll"].includes(getComputedStyle(element).overflowX) || scrolls(element.parentElement));
const width = document.documentElement.clientWidth;
return [...document.body.querySelectorAll("*")]
  .filter((one) => one.getClientRects().length > 0 && one.getBoundingClientRect().right > width + 1)
  .filter((one) => !scrolls(one) && !one.closest("svg:not(:scope)"))
  .map((one) => `${one.tagName}.${one.className} ${one.textContent.slice(0, 40)}`);
"""


def start_browser():
    options = Options()
    options.binary_location = shutil.which("chromium")
    for argument in ("--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--hide-scrollbars"):
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    browser = webdriver.Chrome(service=Service(shutil.which("chromedriver")), options=options)
    browser.set_page_load_timeout(WAIT_S)
    browser.set_script_timeout(WAIT_S)
    return browser


class BrowserTest(unittest.TestCase):
    """One browser for all tests of a class, with selectable screen sizes."""

    @classmethod
    def setUpClass(cls):
        cls.browser = start_browser()
        cls.addClassCleanup(cls.browser.quit)

    def show(self, size, media="screen"):
        width, height = size
        self.browser.execute_cdp_cmd(
            "Emulation.setDeviceMetricsOverride",
            {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": size == PHONE},
        )
        self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": media})

    def show_on_paper(self):
        self.show(PAPER, "print")
        self.browser.execute_script("window.dispatchEvent(new Event('beforeprint'))")
        self.settle()

    def settle(self):
        """Waits until the page has been redrawn."""
        self.browser.execute_async_script(
            "const done = arguments[0]; requestAnimationFrame(() => requestAnimationFrame(() => done()));"
        )

    def text(self, name):
        return self.browser.find_element(By.ID, name).get_attribute("textContent")

    def texts(self, selector):
        return [one.get_attribute("textContent") for one in self.browser.find_elements(By.CSS_SELECTOR, selector)]

    def cut_off(self):
        return self.browser.execute_script(CUT_OFF)

    def scroll_width(self):
        return self.browser.execute_script("return document.documentElement.scrollWidth")

    def wait_until(self, condition):
        WebDriverWait(self.browser, WAIT_S, 0.05).until(lambda _: condition())

    def addresses(self):
        """The URLs of all requests of the page."""
        messages = [json.loads(entry["message"])["message"] for entry in self.browser.get_log("performance")]
        return [
            message["params"]["request"]["url"]
            for message in messages
            if message["method"] == "Network.requestWillBeSent"
        ]

    def leave_picture(self, name):
        folder = os.environ.get("AUTOREF_SCREENSHOTS")
        if folder:
            self.browser.save_screenshot(str(pathlib.Path(folder) / f"{name}.png"))
