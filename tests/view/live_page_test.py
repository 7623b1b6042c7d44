#!/usr/bin/env python3
"""Tests the page of `autoref play --web` in a real browser: live_page_test.py AUTOREF SCENARIO.

Needs the packages of page_test.py. Saves screenshots if AUTOREF_SCREENSHOTS=FOLDER is set.
"""
import re
import subprocess
import sys
import unittest

from browser import DESKTOP, PHONE, BrowserTest
from selenium.webdriver.common.by import By

FOULS = {"match.rules": "2026-b", "a.strategy": "rowdy", "seed": 2}
SHOTS = {"a.strategy": "cobalt1", "b.strategy": "chaser", "seed": 12}
SHORT = {"match.half_s": 10, "seed": 3}


class ShownGame:
    """A game that is played and shown, at any free port unless one is given."""

    def __init__(self, settings, speed, port=0):
        chosen = [word for key, value in settings.items() for word in ("--set", f"{key}={value}")]
        self.process = subprocess.Popen(
            [AUTOREF, "play", SCENARIO, "--web", str(port), "--speed", str(speed), *chosen],
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            text=True,
        )
        self.address = re.search(r"http://\S+", self.process.stderr.readline()).group()
        self.port = int(re.search(r":(\d+)/", self.address).group(1))

    def stop(self):
        self.process.kill()
        self.process.wait()
        self.process.stderr.close()


class LivePage(BrowserTest):
    def setUp(self):
        self.show(DESKTOP)
        self.browser.get("about:blank")  # a page that is open tries to connect
        self.browser.get_log("browser")

    def open(self, settings, speed=1, port=0):
        game = ShownGame(settings, speed, port)
        self.addCleanup(game.stop)
        self.browser.get(game.address)
        self.wait_until(lambda: self.frames() > 30)
        return game

    def value(self, expression):
        """Of the page's script; None until the game is shown."""
        return self.browser.execute_script(
            f"return typeof page === 'undefined' || page === null ? null : {expression};"
        )

    def frames(self):
        return self.value("page.recording.count") or 0

    def test_shows_frames_as_they_are_played(self):
        self.open(FOULS)
        before, drawn = self.frames(), self.value("page.drawn")
        self.wait_until(lambda: self.frames() > before + 30)
        self.assertGreater(self.value("page.drawn"), drawn)
        self.assertEqual(len(self.value("page.recording.robots")), 12)
        self.wait_until(lambda: self.value("page.recording.last_s - page.player.time_s") < 5)
        self.assertEqual(self.browser.get_log("browser"), [])

    def test_lists_events_with_their_reasons(self):
        self.open(FOULS, speed=10)
        self.wait_until(lambda: len(self.texts(".highlight .reason")) > 2)
        events, marks = self.value(
            "[...document.querySelectorAll('#eventList, #marks')].map((one) => one.childElementCount)"
        )
        self.assertEqual(events, marks)
        self.assertNotEqual(self.text("callTitle"), "")
        self.assertNotEqual(self.text("command"), "")
        self.leave_picture("live")

    def test_shows_chains_and_shots_as_they_end(self):
        def counts():
            return [len(self.browser.find_elements(By.CSS_SELECTOR, one)) for one in (".chain", ".shot")]

        self.open(SHOTS, speed=20)
        self.browser.find_element(By.ID, "layer-shots").click()
        self.wait_until(lambda: counts()[0] > 5 and counts()[1] > 1)
        self.assertRegex(self.text("xg"), r"xG \d+\.\d\d : \d+\.\d\d")
        self.leave_picture("live_chains")
        before = counts()
        self.browser.refresh()  # a late watcher gets them again
        self.wait_until(lambda: self.frames() > 30)
        self.wait_until(lambda: all(now >= then for now, then in zip(counts(), before)))
        chains = self.value("page.chains.chains.map((one) => [one.start_s, one.end_s, one.side])")
        self.assertEqual(len({tuple(one) for one in chains}), len(chains))
        self.assertEqual(self.browser.get_log("browser"), [])

    def test_rewinds_and_returns_to_the_present(self):
        self.open(FOULS)
        self.wait_until(lambda: self.value("page.recording.last_s") > 4)
        self.browser.execute_script("page.player.seek(1); page.player.pause();")
        seen = self.frames()
        self.wait_until(lambda: self.frames() > seen + 15)
        self.assertEqual(self.value("page.player.time_s"), 1)
        self.assertEqual(self.browser.find_element(By.ID, "live").get_attribute("aria-pressed"), "false")
        self.browser.find_element(By.ID, "live").click()
        self.wait_until(lambda: self.value("page.recording.last_s - page.player.time_s") < 1)
        self.assertEqual(self.browser.find_element(By.ID, "live").get_attribute("aria-pressed"), "true")

    def test_a_late_watcher_can_rewind_to_the_beginning(self):
        self.open(FOULS, speed=20)
        self.wait_until(lambda: self.value("page.recording.last_s") > 60)
        first_s = self.value("page.recording.first_s")
        self.browser.refresh()
        self.wait_until(lambda: self.frames() > 30)
        self.assertEqual(self.value("page.recording.first_s"), first_s)
        self.assertGreater(len(self.texts(".highlight")), 0)

    def test_says_that_the_game_is_over(self):
        self.open(SHORT, speed=8)
        self.wait_until(lambda: self.text("connection") == "The game is over.")
        self.wait_until(lambda: self.text("stage") == "Post game")

    def test_says_that_the_connection_is_lost_and_finds_the_next_game(self):
        game = self.open(FOULS)
        game.stop()
        self.wait_until(lambda: "connection is lost" in self.text("connection"))
        following = ShownGame(SHORT, 1, game.port)
        self.addCleanup(following.stop)
        # The page is loaded again.
        self.wait_until(lambda: "basic" in (self.value("page.game.teams[0]") or ""))
        self.wait_until(lambda: self.text("connection") == "" and self.frames() > 30)

    def test_fits_on_a_phone(self):
        self.show(PHONE)
        self.open(FOULS)
        self.leave_picture("live_phone")
        self.assertLessEqual(self.scroll_width(), PHONE[0])
        self.assertEqual(self.cut_off(), [])


if __name__ == "__main__":
    SCENARIO, AUTOREF = sys.argv.pop(), sys.argv.pop()
    unittest.main(verbosity=2)
