#!/usr/bin/env python3
"""Tests reports of `autoref report` in a real browser, on a phone and on paper: report_test.py AUTOREF.

Needs the packages of page_test.py; tests plots only if gnuplot is installed.
"""
import pathlib
import subprocess
import sys
import tempfile
import unittest

from browser import DESKTOP, PHONE, BrowserTest
from selenium.webdriver.common.by import By

ROUND_ROBIN = """
schema: 1
kind: roundrobin
about: A small round robin.
base: { match: { half_s: 5 } }
teams:
  basic: { strategy: basic }
  chaser: { strategy: chaser }
  a_rather_long_name_that_somebody_gave_to_a_team: { strategy: zone }
  cobalt: { strategy: cobalt }
pairs: 1
seed: 7
"""

CUP = """
schema: 1
kind: knockout
about: A small cup.
base: { match: { rules: 2026-b, half_s: 5 } }
teams:
  basic: { strategy: basic }
  chaser: { strategy: chaser }
  a_rather_long_name_that_somebody_gave_to_a_team: { strategy: zone }
  cobalt: { strategy: cobalt }
  fifth: { strategy: basic }
third_place: true
seed: 7
"""

WIDTHS = "return [...document.querySelectorAll(arguments[0])].map((one) => [one.scrollWidth, one.clientWidth]);"
STYLES = "return [...document.querySelectorAll(arguments[0])].map((one) => getComputedStyle(one)[arguments[1]]);"


class ReportTest(BrowserTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        folder = pathlib.Path(cls.folder.name)
        (folder / "scenario.yaml").write_text(ROUND_ROBIN)
        for words in (
            ["run", str(folder / "scenario.yaml"), "-o", str(folder / "results")],
            ["report", str(folder / "results")],
        ):
            subprocess.run([AUTOREF, *words], check=True, capture_output=True, timeout=300)
        cls.build = (folder / "results/report.md").read_text().split("| build | ")[1].split(" |")[0]
        # The page is alone in a folder, as if it had been received by mail.
        cls.page = folder / "alone" / "report.html"
        cls.page.parent.mkdir()
        (folder / "results/report.html").rename(cls.page)

    def setUp(self):
        self.show(DESKTOP)
        self.browser.get(self.page.as_uri())

    def test_sent_alone_has_no_dead_links(self):
        links = [one.get_attribute("href") for one in self.browser.find_elements(By.CSS_SELECTOR, "[href], [src]")]
        self.assertEqual([link for link in links if not link.startswith("#")], [])
        self.assertEqual(
            [one for one in self.addresses() if one != self.page.as_uri() and not one.endswith("/favicon.ico")], []
        )
        self.assertIn("effective.yaml", self.texts("code"))

    def test_on_a_phone_scrolls_tables_and_never_the_page(self):
        self.show(PHONE)
        self.leave_picture("report_phone")
        self.assertLessEqual(self.scroll_width(), PHONE[0])
        self.assertEqual(self.cut_off(), [])
        wider = [box for box in self.browser.execute_script(WIDTHS, "pre, .wide") if box[0] > box[1]]
        self.assertTrue(wider, "no table is wide enough for this test")

    def test_on_a_phone_scales_plots_to_the_page(self):
        self.show(PHONE)
        plots = self.browser.find_elements(By.CSS_SELECTOR, "figure svg")
        self.assertGreater(len(plots), 1)
        for plot in plots:
            self.assertLessEqual(plot.rect["x"] + plot.rect["width"], PHONE[0])
            self.assertIsNotNone(plot.get_dom_attribute("viewBox"))
            width, height = [float(part) for part in plot.get_dom_attribute("viewBox").split()[2:]]
            self.assertAlmostEqual(plot.rect["height"], plot.rect["width"] * height / width, delta=2)
            box = plot.find_element(By.XPATH, "..")
            self.assertLessEqual(box.get_property("scrollWidth"), box.get_property("clientWidth"))

    def test_on_a_phone_leaves_room_beside_a_long_name(self):
        self.show(PHONE)
        for width in self.browser.execute_script(
            "return [...document.querySelectorAll('.wide:not(.words) td:first-child')].map((one) => one.offsetWidth)"
        ):
            self.assertLess(width, 0.6 * PHONE[0])

    def test_shows_the_whole_build_on_a_phone(self):
        self.show(PHONE)
        cells = [
            one for one in self.browser.find_elements(By.CSS_SELECTOR, "td") if one.text.replace("\n", "") == self.build
        ]
        self.assertEqual(len(cells), 1)
        self.assertLessEqual(cells[0].rect["x"] + cells[0].rect["width"], PHONE[0])

    def test_on_paper_cuts_nothing_off(self):
        self.show_on_paper()
        self.leave_picture("report_paper")
        self.assertEqual(self.cut_off(), [])
        for selector in ("pre", ".wide", "figure"):
            for scroll, client in self.browser.execute_script(WIDTHS, selector):
                self.assertLessEqual(scroll, client + 1, selector)

    def test_on_paper_has_no_dark_backgrounds(self):
        self.show_on_paper()
        for color in self.browser.execute_script(STYLES, "body, pre, td, th", "backgroundColor"):
            self.assertIn(color, ("rgba(0, 0, 0, 0)", "rgb(255, 255, 255)"))

    def test_on_paper_breaks_no_row_and_no_plot(self):
        self.show_on_paper()
        self.assertEqual(set(self.browser.execute_script(STYLES, "tr, figure", "breakInside")), {"avoid"})
        self.assertEqual(set(self.browser.execute_script(STYLES, "h2", "breakAfter")), {"avoid"})
        self.assertEqual(set(self.browser.execute_script(STYLES, "thead", "display")), {"table-header-group"})


class CupReportTest(BrowserTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        folder = pathlib.Path(cls.folder.name)
        (folder / "cup.yaml").write_text(CUP)
        for words in (["run", str(folder / "cup.yaml"), "-o", str(folder)], ["report", str(folder)]):
            subprocess.run([AUTOREF, *words], check=True, capture_output=True, timeout=300)
        cls.page = folder / "report.html"

    def setUp(self):
        self.show(DESKTOP)
        self.browser.get(self.page.as_uri())

    def test_draws_each_tie_beside_those_that_lead_to_it(self):
        first, *rest = [one.rect for one in self.browser.find_elements(By.CSS_SELECTOR, ".tie > div")]
        semi_finals, final = rest[:2], rest[2]
        self.assertLess(first["x"], semi_finals[0]["x"])
        self.assertLess(semi_finals[0]["x"], final["x"])
        middles = [one["y"] + one["height"] / 2 for one in (*semi_finals, final)]
        self.assertAlmostEqual(middles[2], sum(middles[:2]) / 2, delta=3)
        self.leave_picture("report_cup")

    def test_lists_the_rounds_on_a_phone(self):
        self.show(PHONE)
        self.assertLessEqual(self.scroll_width(), PHONE[0])
        self.assertEqual(self.cut_off(), [])
        ties = [one.rect for one in self.browser.find_elements(By.CSS_SELECTOR, ".tie > div")]
        self.assertEqual(len({one["x"] for one in ties}), 1)
        self.assertEqual(sorted(one["y"] for one in ties), [one["y"] for one in ties])
        self.leave_picture("report_cup_phone")

    def test_fits_on_paper(self):
        self.show_on_paper()
        self.assertEqual(self.cut_off(), [])


if __name__ == "__main__":
    AUTOREF = sys.argv.pop()
    unittest.main(verbosity=2)
