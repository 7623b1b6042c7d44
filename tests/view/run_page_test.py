#!/usr/bin/env python3
"""Tests the page of `autoref run --web` in a real browser: run_page_test.py AUTOREF.

Needs the packages of page_test.py. Saves screenshots if AUTOREF_SCREENSHOTS=FOLDER is set.
"""
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

from browser import DESKTOP, PHONE, BrowserTest
from selenium.webdriver.common.by import By

TEAMS = """
teams:
  basic: { strategy: basic }
  chaser: { strategy: chaser }
  a_rather_long_name_that_somebody_gave_to_a_team: { strategy: zone }
  cobalt: { strategy: cobalt }
"""
ABOUT = "A <b>small</b> league <img src=x onerror='document.title=1'>"
LEAGUE = f"""
schema: 1
kind: roundrobin
about: "{ABOUT}"
base: {{ match: {{ half_s: HALF_S }} }}
pairs: 2
seed: 7
{TEAMS}"""
CUP = f"""
schema: 1
kind: knockout
base: {{ match: {{ rules: 2026-b, half_s: HALF_S }} }}
order: [cobalt, a_rather_long_name_that_somebody_gave_to_a_team, basic, chaser, fifth]
third_place: true
seed: 2
{TEAMS}  fifth: {{ strategy: basic }}
"""
LONG, SHORT = 300, 20  # halves, in s


class RunPage(BrowserTest):
    def setUp(self):
        self.show(DESKTOP)
        self.browser.get("about:blank")
        self.browser.get_log("browser")

    def open(self, scenario, half_s):
        """Opens the page of a run that has just begun."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        file = pathlib.Path(folder.name) / "spring.yaml"
        file.write_text(scenario.replace("HALF_S", str(half_s)))
        run = subprocess.Popen(
            [AUTOREF, "run", file, "-o", f"{folder.name}/results", "-j", "1", "--web", "0"],
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            text=True,
        )
        self.addCleanup(run.stderr.close)
        self.addCleanup(run.wait)
        self.addCleanup(run.kill)
        self.browser.get(re.search(r"http://\S+", run.stderr.readline()).group())

    def wait_for_results(self):
        self.wait_until(lambda: self.texts("#ended .game"))
        self.wait_until(lambda: self.texts("#results table, #results .tie-team.has-won"))

    def wait_for_the_end(self):
        self.wait_until(lambda: self.text("connection") == "The run is over.")

    def texts(self, selector):
        """In one step: an update may replace the elements at any time."""
        return self.browser.execute_script(
            "return [...document.querySelectorAll(arguments[0])].map((one) => one.textContent);", selector
        )

    def headings(self):
        return self.texts("#results h2")

    def test_shows_the_tables_of_a_tournament_while_it_is_played(self):
        self.open(LEAGUE, LONG)
        self.wait_for_results()
        self.assertRegex(self.text("progress"), r"^\d+/24 games")
        self.assertIn("Do not stop early", self.text("remark"))
        self.assertEqual(self.headings(), ["Standings", "Crosstable", "Matchups"])
        standings = self.texts("#results table:first-of-type")[0]
        self.assertIn("rating in goals [95 %]", standings)
        self.wait_until(lambda: len(self.texts("#running .game")) == 1)
        self.leave_picture("run")
        self.assertEqual(self.browser.get_log("browser"), [])

    def test_shows_the_scenarios_text_verbatim(self):
        self.open(LEAGUE, LONG)
        self.assertEqual(self.texts("h1"), [ABOUT])
        self.assertEqual(self.browser.find_elements(By.CSS_SELECTOR, "h1 *"), [])

    def test_runs_no_handlers_in_what_the_server_sends(self):
        self.open(LEAGUE, LONG)
        self.wait_for_results()
        self.browser.execute_script("showResults({html: '<img src=data:, onerror=\"window.isRun = 1\">'})")
        self.settle()
        self.assertIsNone(self.browser.execute_script("return window.isRun ?? null"))
        self.assertTrue(any("Content Security" in one["message"] for one in self.browser.get_log("browser")))

    def test_links_to_the_page_of_a_game(self):
        self.open(LEAGUE, LONG)
        self.wait_for_results()
        link, score = self.browser.execute_script(
            "const game = document.querySelector('#ended a.game'); return [game.href, game.textContent];"
        )
        self.assertIn("/game?", link)
        self.browser.get(link)
        self.browser.execute_script("page.player.seek(page.recording.last_s)")
        self.settle()
        goals = sorted([self.text("goals0"), self.text("goals1")])
        self.assertEqual(goals, sorted(re.search(r"(\d+):(\d+)", score).groups()))

    def test_follows_a_tournament_to_its_end(self):
        self.open(LEAGUE, SHORT)
        self.wait_for_the_end()
        self.assertRegex(self.text("progress"), r"^24/24 games")
        self.assertEqual(self.text("remark"), "")
        self.assertEqual(self.texts("#running .game"), [])
        self.assertEqual(len(self.texts("#ended .game")), 24)
        self.leave_picture("run_end")

    def test_keeps_the_position_of_a_scrolled_table(self):
        self.show(PHONE)
        self.open(LEAGUE, LONG)
        self.wait_for_results()
        self.browser.execute_script("document.querySelector('#results .wide').scrollLeft = 60")
        count = len(self.texts("#ended .game"))
        self.wait_until(lambda: len(self.texts("#ended .game")) > count + 2)
        self.assertEqual(self.browser.execute_script("return document.querySelector('#results .wide').scrollLeft"), 60)

    def test_a_tournament_fits_on_a_phone(self):
        self.show(PHONE)
        self.open(LEAGUE, LONG)
        self.wait_for_results()
        self.leave_picture("run_phone")
        self.assertLessEqual(self.scroll_width(), PHONE[0])
        self.assertEqual(self.cut_off(), [])

    def test_fills_in_the_bracket_of_a_cup(self):
        self.open(CUP, SHORT)
        self.assertEqual(self.texts("h1"), ["spring"])
        self.wait_for_the_end()
        self.assertEqual(self.texts(".round-name"), ["quarter-finals", "semi-finals", "final"])
        self.assertEqual(len(self.texts(".tie")), 5)
        self.assertEqual(len(self.texts(".tie-team.has-won")), 5)
        self.assertEqual(self.texts(".tie-team.is-open"), [])
        self.leave_picture("cup")

    def test_a_cup_fits_on_a_phone(self):
        self.show(PHONE)
        self.open(CUP, LONG)
        self.wait_for_results()
        self.leave_picture("cup_phone")
        self.assertLessEqual(self.scroll_width(), PHONE[0])
        self.assertEqual(self.cut_off(), [])
        right_px = self.browser.execute_script(
            "return [...document.querySelectorAll('.tie > div')].map((one) => one.getBoundingClientRect().right);"
        )
        self.assertEqual(len(right_px), 5)
        self.assertLessEqual(max(right_px), PHONE[0])

    def test_breaks_no_short_name_on_a_phone(self):
        self.show(PHONE)
        self.open(LEAGUE, LONG)
        self.wait_for_results()
        heights_px = self.browser.execute_script(
            "return [...document.querySelectorAll('#results td.name:first-child')]"
            ".filter((one) => one.textContent.length < 12).map((one) => one.offsetHeight);"
        )
        self.assertLess(max(heights_px), 40)


if __name__ == "__main__":
    AUTOREF = sys.argv.pop()
    unittest.main(verbosity=2)
