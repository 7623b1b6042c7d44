#!/usr/bin/env python3
"""Tests the page of `autoref play --view` in a real browser: page_test.py AUTOREF SCENARIO.

Needs Debian's chromium, chromium-driver and python3-selenium. Saves screenshots if
AUTOREF_SCREENSHOTS=FOLDER is set.
"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

from browser import DESKTOP, PHONE, PROJECTOR, BrowserTest
from game_page import GamePage, played_game
from selenium import webdriver
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import Select

YELLOW, BLUE, BALL = (255, 212, 59), (74, 157, 255), (255, 123, 28)

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


# Pixels of a colour beyond the left and the right goal line, where only the goals are.
COUNT_AT_ENDS = """
const [red, green, blue] = arguments[0];
const canvas = document.querySelector("canvas");
const {halfLength_mm} = page.game.field;
const width = Math.floor(canvas.width / 2 - page.pitch.scale * (halfLength_mm + page.game.shapes.robotRadius_mm));
return [0, canvas.width - width].map((left) => {
  const {data} = canvas.getContext("2d").getImageData(left, 0, width, canvas.height);
  let count = 0;
  for (let i = 0; i < data.length; i += 4) {
    const far = Math.abs(data[i] - red) + Math.abs(data[i + 1] - green) + Math.abs(data[i + 2] - blue);
    if (far < 12) ++count;
  }
  return count;
});
"""

AVERAGE_BRIGHTNESS = """
const canvas = document.querySelector("canvas");
const {data} = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
let sum = 0;
for (let i = 0; i < data.length; i += 4) sum += data[i] + data[i + 1] + data[i + 2];
return sum / (3 * data.length / 4);
"""


SCAN_STEP_S = 0.1

# The time, the last command and the pill's text, every SCAN_STEP_S.
SCAN_PILL = f"""
const found = [];
for (let time_s = page.recording.first_s; time_s < page.recording.last_s; time_s += {SCAN_STEP_S}) {{
  page.player.seek(time_s);
  page.show();
  const signal = page.game.signals[lastNotAfter(page.game.signals, time_s + 1e-6, (one) => one.time_s)];
  found.push([time_s, signal?.command ?? "", document.getElementById("command").textContent]);
}}
return found;
"""


class PageTest(GamePage):
    """A game in which cobalt scores several goals."""

    settings = {"a__strategy": "cobalt1", "b__strategy": "chaser", "match__half_s": 150, "seed": 12}

    def test_loads_without_complaints(self):
        self.assertEqual(self.browser.get_log("browser"), [])

    def test_uses_no_network(self):
        addresses = self.addresses()
        self.assertIn(self.page.as_uri(), addresses)
        self.assertEqual([one for one in addresses if not one.startswith(("file:", "data:"))], [])

    def test_shows_both_teams_and_the_ball(self):
        self.assertEqual([self.text("team0"), self.text("team1")], ["cobalt1", "chaser"])
        for color in (YELLOW, BLUE, BALL):
            self.assertGreater(self.pixels(color), 10)

    def test_plays_and_pauses_with_the_space_bar(self):
        self.press(" ")
        self.wait_until(lambda: self.time_s() > 0.3)
        self.press(" ")
        stands_at_s = self.time_s()
        print(f"{self.browser.execute_async_script(COUNT_FRAMES):.0f} frames per second while paused")
        self.assertEqual(self.time_s(), stands_at_s)

    def test_is_redrawn_while_playing(self):
        self.press("+ ")
        frames = self.browser.execute_async_script(COUNT_FRAMES)
        print(f"{frames:.0f} frames per second while playing")
        self.assertGreater(frames, 0.5)  # even on a busy machine without a GPU

    def test_steps_by_one_frame(self):
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

    def test_steps_back_before_a_goal_and_forward_again(self):
        self.press("g")
        self.press("," * 5)
        self.assertEqual(sum(self.score()), 0)
        self.press("." * 5)
        self.assertEqual(sum(self.score()), 1)

    def test_jumps_to_a_goal_when_its_mark_is_clicked(self):
        marks = self.browser.find_elements(By.CSS_SELECTOR, ".mark.goal")
        self.assertEqual(len(marks), self.record["goals_a"] + self.record["goals_b"])
        marks[-1].click()
        self.settle()
        self.assertEqual(self.score(), [self.record["goals_a"], self.record["goals_b"]])
        self.leave_picture("desktop")

    def test_opens_at_the_moment_and_with_the_layers_of_its_address(self):
        self.browser.get("about:blank")
        self.browser.get(self.page.as_uri() + "#t=12.5&with=speeds,nonsense")
        self.settle()
        self.assertAlmostEqual(self.time_s(), 12.5, delta=0.02)
        pressed = {
            name: self.browser.find_element(By.ID, f"layer-{name}").get_attribute("aria-pressed")
            for name in ("trails", "speeds", "heat")
        }
        self.assertEqual(pressed, {"trails": "true", "speeds": "true", "heat": "false"})

    def test_jumps_to_the_clicked_time(self):
        line = self.browser.find_element(By.ID, "timeline")
        webdriver.ActionChains(self.browser).move_to_element_with_offset(
            line, 0, line.size["height"] // 2 - 4
        ).click().perform()
        self.settle()
        minutes, seconds = self.text("length").split(":")
        self.assertAlmostEqual(self.time_s(), (60 * int(minutes) + int(seconds)) / 2, delta=2)

    def test_shows_why_the_referee_stopped_play(self):
        stops = self.browser.find_elements(By.CSS_SELECTOR, ".highlight.stop .reason")
        self.assertGreater(len(stops), 0)
        self.press("n")
        self.assertNotEqual(self.text("callReason"), "")

    def test_says_in_play_while_and_only_while_the_ball_is(self):
        pills = self.browser.execute_script(SCAN_PILL)
        in_play_s = sum(1 for _, _, pill in pills if pill == "In play") * SCAN_STEP_S
        self.assertAlmostEqual(in_play_s, self.record["ball_in_play_s"], delta=0.04 * self.record["ball_in_play_s"] + 1)
        for time_s, command, pill in pills:
            if command in ("HALT", "STOP") or command.startswith(("GOAL", "PREPARE", "BALL_PLACEMENT", "TIMEOUT")):
                self.assertNotEqual(pill, "In play", time_s)
        self.assertNotIn("Force start", [pill for _, _, pill in pills])
        self.assertIn("Direct free kick, yellow", [pill for _, _, pill in pills])  # until it is taken
        self.leave_picture("in_play")

    def test_takes_a_ball_that_is_not_seen_for_one_that_has_not_moved(self):
        frames = self.browser.execute_script(
            """
            const signal = {...page.game.signals.find((one) => one.command.startsWith("DIRECT_FREE"))};
            const real = freedAt(page.recording, signal);
            const begin = page.recording.indexAt(signal.time_s);
            const hidden = {...page.recording, indexAt: () => begin, ball: {...page.recording.ball}};
            hidden.ball.x = hidden.ball.x.map((x, i) => i === begin || i === begin + 2 ? kNothing : x);
            signal.freedAt = undefined;
            return [begin, real, freedAt(hidden, signal)];"""
        )
        self.assertGreater(frames[1], frames[0] + 3)
        self.assertAlmostEqual(frames[2], frames[1], delta=1)

    def test_draws_each_layer(self):
        self.press("gg" + Keys.ARROW_LEFT)
        for key in "1234":
            before = self.browser.execute_script("return document.querySelector('canvas').toDataURL()")
            self.press(key)
            after = self.browser.execute_script("return document.querySelector('canvas').toDataURL()")
            # Distances are checked only at restarts.
            if key != "3":
                self.assertNotEqual(before, after, f"layer {key}")

    def test_opens_and_closes_help(self):
        def is_open():
            return self.browser.execute_script("return document.getElementById('help').open")

        self.press("?")
        self.assertTrue(is_open())
        self.press(Keys.ESCAPE)
        self.wait_until(lambda: not is_open())

    def test_fits_a_phone_and_a_projector(self):
        for size, name in ((PHONE, "phone"), (PROJECTOR, "projector")):
            self.show(size)
            self.settle()
            self.assertLessEqual(self.scroll_width(), size[0])
            self.assertEqual(self.cut_off(), [])
            self.leave_picture(name)
        self.assertLessEqual(self.browser.execute_script("return document.documentElement.scrollHeight"), PROJECTOR[1])

    def test_has_no_links_and_needs_no_other_file(self):
        self.assertEqual(self.browser.find_elements(By.CSS_SELECTOR, "a, iframe, object"), [])

    def test_shows_the_whole_build(self):
        for size in (PHONE, DESKTOP):
            self.show(size)
            self.settle()
            self.assertIn(f"build {self.record['build']}", self.texts(".fact"))
            fact = self.browser.find_element(By.CSS_SELECTOR, ".fact:last-child")
            self.assertLessEqual(fact.rect["x"] + fact.rect["width"], size[0])
            self.assertGreater(fact.rect["height"], 5)

    def test_prints_all_events_on_white(self):
        self.assertLess(self.browser.execute_script(AVERAGE_BRIGHTNESS), 100)
        self.show_on_paper()
        self.leave_picture("paper")
        self.assertGreater(self.browser.execute_script(AVERAGE_BRIGHTNESS), 220)
        self.assertEqual(self.cut_off(), [])
        hidden = self.browser.execute_script(
            "const list = document.getElementById('eventList'); return list.scrollHeight - list.clientHeight;"
        )
        self.assertLessEqual(hidden, 1)
        breaks = self.browser.execute_script(
            "return getComputedStyle(document.querySelector('#eventList li')).breakInside"
        )
        self.assertEqual(breaks, "avoid")
        self.browser.execute_script("window.dispatchEvent(new Event('afterprint'))")
        self.assertLess(self.browser.execute_script(AVERAGE_BRIGHTNESS), 100)


class WinProbabilityPageTest(GamePage):
    """A game that yellow wins."""

    settings = {**PageTest.settings, "match__rules": "2026-b", "seed": 7}

    def shown_wins(self):
        """The probabilities in per cent that yellow and blue win, as shown."""
        return [int(one) for one in self.text("win").removeprefix("win ").replace(" %", "").split(" : ")]

    def turning_points(self):
        return self.browser.find_elements(By.CSS_SELECTOR, "#turningPointList .highlight")

    def begin_s(self, turn):
        minutes, seconds = turn.find_element(By.CLASS_NAME, "when").text.split(":")
        return 60 * int(minutes) + int(seconds)

    def test_is_even_at_first_and_certain_at_the_end(self):
        yellow, blue = self.shown_wins()
        self.assertLess(abs(yellow - blue), 25)
        self.press(Keys.END)
        self.assertGreater(self.score()[0], self.score()[1])
        yellow, blue = self.shown_wins()
        self.assertGreater(yellow, 95)
        self.assertLess(blue, 5)

    def test_draws_an_area_for_each_team_and_seeks_where_it_is_clicked(self):
        self.leave_picture("win_probability")
        for name in ("winYellow", "winBlue"):
            points = self.browser.find_element(By.ID, name).get_attribute("points").split()
            self.assertGreater(len(points), 30)
            heights = [float(point.split(",")[1]) for point in points]
            self.assertGreaterEqual(min(heights), 0)
            self.assertLessEqual(max(heights), 100)
            self.assertGreater(max(heights[1:-1]) - min(heights[1:-1]), 20)
            self.assertGreater(heights[-2], 90)  # yellow wins
        self.browser.find_element(By.ID, "winChart").click()  # its middle
        self.settle()
        length_s = self.browser.execute_script("return page.recording.length_s")
        self.assertAlmostEqual(self.time_s(), length_s / 2, delta=0.01 * length_s)

    def test_lists_the_turning_points_in_order(self):
        turns = self.turning_points()
        self.assertIn(len(turns), range(2, 6))
        begins_s = [self.begin_s(turn) for turn in turns]
        self.assertEqual(begins_s, sorted(begins_s))
        self.assertIn("Goal for yellow", " ".join(turn.text for turn in turns))
        for turn in turns:
            before, after = re.findall(r"(\d+) %", turn.find_element(By.CLASS_NAME, "reason").text)
            self.assertGreaterEqual(int(after), int(before))

    def test_goes_to_a_turning_point(self):
        first, *_ = self.turning_points()
        first.click()
        self.settle()
        self.assertAlmostEqual(self.time_s(), self.begin_s(first), delta=1)
        self.press("m")
        self.assertAlmostEqual(self.time_s(), self.begin_s(self.turning_points()[1]), delta=1)
        self.press("M")
        self.assertAlmostEqual(self.time_s(), self.begin_s(first), delta=1)

    def test_fits_a_phone(self):
        self.show(PHONE)
        self.leave_picture("win_probability_phone")
        self.assertLessEqual(self.scroll_width(), PHONE[0])
        self.assertEqual(self.cut_off(), [])


class ChainsPageTest(GamePage):
    """A game in which cobalt shoots and scores in both halves, with a change of ends."""

    settings = {**PageTest.settings, "match__rules": "2026-b", "seed": 7}
    titles = {
        "kick_off": "kick-off",
        "throw_in": "throw-in",
        "lost": "ball lost",
        "out": "ball out",
        "whistle": "play stopped",
    }

    def words(self, name):
        return self.titles.get(name, name.replace("_", " "))

    def description(self, row):
        """What the page should say about a chain of the CSV file."""
        passes, shots = int(row["passes"]), int(row["shots"])
        parts = [self.words(row["start"])]
        parts += ["1 pass" if passes == 1 else f"{passes} passes"] if passes else []
        parts += [f"{'shot' if shots == 1 else f'{shots} shots'} (xG {float(row['xg']):.2f})"] if shots else []
        parts += [self.words(row["end"])] if row["end"] != "shot" else []
        return f"{'Yellow' if row['team'] == 'a' else 'Blue'}: {', '.join(parts)}"

    def choose(self, box, name):
        Select(self.browser.find_element(By.ID, box)).select_by_value(name)
        self.settle()

    def unfaded(self):
        return len(self.browser.find_elements(By.CSS_SELECTOR, ".chain:not(.faded)"))

    def dots(self):
        return self.browser.find_elements(By.CSS_SELECTOR, ".shot")

    def test_shows_every_chain_in_its_teams_colour(self):
        for side, team in enumerate("ab"):
            shown = self.browser.find_elements(By.CSS_SELECTOR, f".chain[data-side='{side}']")
            self.assertEqual(len(shown), sum(row["team"] == team for row in self.chains))
            shirt = self.browser.find_element(By.CSS_SELECTOR, f".team[data-side='{side}'] > .shirt")
            self.assertEqual(*[one.value_of_css_property("background-color") for one in (shown[0], shirt)])

    def test_raises_chains_with_a_shot_and_those_with_a_goal_most(self):
        def height(selector):
            return self.browser.find_element(By.CSS_SELECTOR, selector).size["height"]

        self.assertGreater(height(".chain.withShot[data-end=shot]"), height(".chain:not(.withShot)"))
        self.assertGreater(height(".chain[data-end=goal]"), height(".chain.withShot[data-end=shot]"))
        with_shot = self.browser.find_elements(By.CSS_SELECTOR, ".chain.withShot")
        self.assertEqual(len(with_shot), sum(int(row["shots"]) > 0 for row in self.chains))

    def test_describes_the_chain_under_the_pointer_and_seeks_its_beginning(self):
        number = next(i for i, row in enumerate(self.chains) if int(row["shots"]) and int(row["passes"]))
        segment = self.browser.find_elements(By.CSS_SELECTOR, ".chain")[number]
        webdriver.ActionChains(self.browser).move_to_element(segment).perform()
        row = self.chains[number]
        self.assertTrue(self.description(row) in self.text("chain"), self.text("chain"))
        self.assertEqual(self.time_s(), 0)
        segment.click()
        self.settle()
        self.assertAlmostEqual(self.time_s(), float(row["start_s"]), delta=0.02)
        self.leave_picture("chains")

    def test_describes_the_chain_in_progress(self):
        for row in [one for one in self.chains if float(one["end_s"]) - float(one["start_s"]) > 0.1][:40]:
            middle_s = (float(row["start_s"]) + float(row["end_s"])) / 2
            self.browser.execute_script("page.player.seek(arguments[0]); page.show();", middle_s)
            self.assertIn(self.description(row), self.text("chain"))

    def actions_of(self, chain):
        """The actions of a chain of the CSV file."""
        own = [one for one in self.chains if one["team"] == chain["team"]]
        following = own[own.index(chain) + 1 :]
        until_s = float(following[0]["start_s"]) if following else float("inf")
        actions = [one for one in self.actions if one["team"] == chain["team"] and one["action"] != "foul"]
        return [one for one in actions if float(chain["start_s"]) <= float(one["start_s"]) < until_s]

    def test_says_what_the_actions_of_a_chain_were_worth(self):
        chain = max(self.chains, key=lambda one: len(self.actions_of(one)))
        self.browser.execute_script("page.player.seek(arguments[0]); page.show();", float(chain["start_s"]) + 0.02)
        actions = self.actions_of(chain)
        self.assertGreater(len(actions), 2)
        names = [f"{one['robot']} {one['action']} " for one in actions]
        worths = [float(one["worth"]) for one in actions]
        total = self.text("chain").split(", worth ")[1].replace("\u2212", "-")
        self.assertAlmostEqual(float(total), sum(worths), delta=0.011)
        listed = [one.text.replace("\u2212", "-") for one in self.drawn("#chainActionList li")]
        for text, name, worth in zip(listed, names, worths, strict=True):
            self.assertTrue(text.startswith(name), text)
            self.assertAlmostEqual(float(text[len(name) :]), worth, delta=0.0101)

    def test_draws_the_paths_and_losses_of_the_selected_chains(self):
        self.press("78")
        self.assertEqual(len(self.drawn("#paths line")), sum(one["action"] != "foul" for one in self.actions))
        losses = [one for one in self.actions if one["action"] == "loss"]
        self.assertEqual(len(self.drawn("#losses circle")), len(losses))
        self.choose("chainSide", "0")
        self.assertEqual(len(self.drawn("#losses circle")), sum(one["team"] == "a" for one in losses))
        self.leave_picture("losses")
        self.press("78")
        self.assertEqual(self.drawn("#paths line") + self.drawn("#losses circle"), [])

    def drawn(self, selector):
        return [one for one in self.browser.find_elements(By.CSS_SELECTOR, selector) if one.is_displayed()]

    def test_fades_the_chains_that_the_filter_does_not_select(self):
        for box, key, names in (("chainStart", "start", 10), ("chainEnd", "end", 8)):
            options = self.texts(f"#{box} option")
            self.assertEqual(len(options), names + 1)
            for name in {row[key] for row in self.chains}:
                self.choose(box, name)
                count = sum(row[key] == name for row in self.chains)
                self.assertEqual(self.unfaded(), count)
                self.assertEqual(self.text("chainCount"), f"{count} of {len(self.chains)} chains")
            self.choose(box, "")
        self.choose("chainSide", "1")
        self.assertEqual(self.unfaded(), sum(row["team"] == "b" for row in self.chains))
        self.choose("chainSide", "")
        self.assertEqual(self.unfaded(), len(self.chains))

    def test_jumps_between_selected_chains(self):
        self.browser.find_element(By.ID, "withShot").click()
        starts_s = [float(row["start_s"]) for row in self.chains if int(row["shots"])]
        for start_s in starts_s[:3]:
            self.press("c")
            self.assertAlmostEqual(self.time_s(), start_s, delta=0.02)
            self.assertIn("shot", self.text("chain"))
        self.press("C")
        self.assertAlmostEqual(self.time_s(), starts_s[1], delta=0.02)
        self.browser.find_element(By.CSS_SELECTOR, "[data-action=previousChain]").click()
        self.settle()
        self.assertAlmostEqual(self.time_s(), starts_s[0], delta=0.02)

    def test_leaves_the_arrow_keys_to_a_list_of_choices(self):
        box = self.browser.find_element(By.ID, "chainEnd")
        box.send_keys(Keys.ARROW_RIGHT)
        self.settle()
        self.assertEqual(self.time_s(), 0)

    def test_maps_the_shots_that_the_filter_selects(self):
        self.assertFalse(self.browser.find_element(By.ID, "shots").is_displayed())
        self.press("6")
        self.assertEqual(len(self.dots()), sum(int(row["shots"]) for row in self.chains))
        scored = self.browser.find_elements(By.CSS_SELECTOR, ".shot.scored")
        self.assertEqual(len(scored), sum(row["end"] == "goal" for row in self.chains))
        self.assertTrue(all(dot.is_displayed() for dot in self.dots()))
        self.leave_picture("shots")
        self.choose("chainEnd", "goal")
        self.assertEqual(len(self.dots()), sum(int(row["shots"]) for row in self.chains if row["end"] == "goal"))
        self.assertTrue(all("Yellow: " in dot.get_attribute("title") for dot in self.dots()))

    def test_seeks_just_before_a_clicked_shot(self):
        self.press("6")
        dot = self.dots()[-1]
        minutes, seconds = dot.get_attribute("title").split()[0].split(":")
        self.browser.execute_script("arguments[0].click()", dot)
        self.settle()
        before_s = 60 * int(minutes) + int(seconds) - self.time_s()
        self.assertGreater(before_s, 0)
        self.assertLessEqual(before_s, 1.01)

    def test_draws_areas_in_proportion_to_the_chances(self):
        self.press("6")
        sizes = [
            (float(dot.get_attribute("title").rsplit(" ", 1)[1]), dot.rect["width"] * dot.rect["height"])
            for dot in self.dots()
        ]
        (small_xg, small), *_, (large_xg, large) = sorted(size for size in sizes if size[0] > 0.1)
        self.assertGreater(large_xg, 1.3 * small_xg)
        self.assertAlmostEqual(large / small, large_xg / small_xg, delta=0.1 * large / small)

    def test_knows_where_the_ball_was_at_each_shot_in_both_halves(self):
        shots = self.browser.execute_script(
            """
            return page.chains.shots.map(({time_s, position_mm: [x, y]}) => {
              const {ball, yellowEnd} = page.recording.sceneAt(time_s);
              return [yellowEnd, Math.hypot(ball.x - x, ball.y - y)];
            });"""
        )
        self.assertEqual({end for end, _ in shots}, {0, 1})
        self.assertLess(max(distance for _, distance in shots), 150)

    def test_puts_all_shots_on_the_field_as_if_the_teams_had_kept_their_ends(self):
        def mean_x():
            pitch = self.browser.find_element(By.ID, "pitch").rect
            dots = self.browser.find_elements(By.CSS_SELECTOR, ".shot.scored")
            return sum(dot.rect["x"] - pitch["x"] - pitch["width"] / 2 for dot in dots) / len(dots)

        self.press("6")
        self.assertGreater(mean_x(), 0)  # yellow attacks to the right
        self.press(Keys.END)
        self.assertLess(mean_x(), 0)

    def test_adds_up_the_expected_goals(self):
        self.assertEqual(self.text("xg"), "xG 0.00 : 0.00")
        self.press(Keys.END)
        xg = [float(one) for one in self.text("xg").removeprefix("xG ").split(" : ")]
        for shown, team in zip(xg, "ab"):
            self.assertAlmostEqual(shown, self.record[f"xg_{team}"], delta=0.02)
        self.assertGreater(xg[0], 0.5)

    def test_fits_a_phone(self):
        self.show(PHONE)
        self.press("6")
        self.leave_picture("chains_phone")
        self.assertLessEqual(self.scroll_width(), PHONE[0])
        self.assertEqual(self.cut_off(), [])


class ShootoutPageTest(GamePage):
    """A knockout game between two teams of the same strategy that ends in a shoot-out."""

    settings = {"match__rules": "2026-b", "match__knockout": "true", "match__half_s": 20, "match__extra_half_s": 10}

    def setUp(self):
        super().setUp()
        self.assertIsNotNone(self.record["shootout"])

    def kicks(self):
        """Side, number, whether it scored, and the score, from the list of events."""
        pattern = re.compile(r"Kick (\d+) of (yellow|blue): (goal|no goal), (\d+)\s:\s(\d+)")
        found = [pattern.fullmatch(title) for title in self.texts(".highlight .title")]
        return [(one[2], int(one[1]), one[3] == "goal", (int(one[4]), int(one[5]))) for one in found if one]

    def test_lists_kickers_results_and_the_score(self):
        numbers, goals = {"yellow": 0, "blue": 0}, {"yellow": 0, "blue": 0}
        kicks = self.kicks()
        for colour, number, has_scored, standing in kicks:
            numbers[colour] += 1
            goals[colour] += has_scored
            self.assertEqual(number, numbers[colour])
            self.assertEqual(standing, (goals["yellow"], goals["blue"]))
        self.assertEqual([goals["yellow"], goals["blue"]], self.record["shootout"])
        self.assertIn(False, [kick[2] for kick in kicks])

    def test_shows_kicks_on_the_time_line(self):
        score = self.record["goals_a"] + self.record["goals_b"] + sum(self.record["shootout"])
        self.assertEqual(len(self.browser.find_elements(By.CSS_SELECTOR, ".mark.goal")), score)
        self.assertEqual(
            len(self.browser.find_elements(By.CSS_SELECTOR, ".mark.miss")),
            len([kick for kick in self.kicks() if not kick[2]]),
        )

    def test_says_why_a_kick_did_not_score(self):
        reasons = self.texts(".highlight.miss .reason")
        self.assertTrue(reasons and all(reasons))

    def test_jumps_to_a_kick_when_its_button_is_clicked_and_shows_the_score(self):
        buttons = self.browser.find_elements(By.CSS_SELECTOR, "#shootout .kick")
        self.assertEqual(len(buttons), len(self.kicks()))
        self.browser.find_elements(By.CSS_SELECTOR, "#shootout .kickRow:last-child .kick")[0].click()
        self.settle()
        _, _, has_scored, standing = next(kick for kick in self.kicks() if kick[:2] == ("blue", 1))
        self.assertEqual(
            self.text("callTitle").split("  ")[1],
            f"Kick 1 of blue: {'goal' if has_scored else 'no goal'}, " f"{standing[0]}\u00a0:\u00a0{standing[1]}",
        )
        shown = [self.text("goals0"), self.text("goals1")]
        self.assertEqual([one.split()[1] for one in shown], [f"({one})" for one in standing])
        self.leave_picture("shootout")

    def test_distinguishes_two_teams_with_the_same_strategy(self):
        self.assertEqual([self.text("team0"), self.text("team1")], ["basic (a)", "basic (b)"])

    def test_fits_a_phone(self):
        self.show(PHONE)
        self.settle()
        self.assertLessEqual(self.scroll_width(), PHONE[0])
        self.assertEqual(self.cut_off(), [])


class EndsPageTest(GamePage):
    """A game of two halves in which the teams change ends."""

    settings = {"match__rules": "2026-b", "match__half_s": 10}

    def goals(self):
        """Whether yellow and blue goals are at the left and at the right."""
        return [
            [count > 10 for count in self.browser.execute_script(COUNT_AT_ENDS, list(color))]
            for color in (YELLOW, BLUE)
        ]

    def seek_second_half(self):
        while "End of the half" not in self.text("callTitle"):
            self.press("n")
        self.press(Keys.ARROW_RIGHT)
        self.assertEqual(self.text("stage"), "Second half, about to begin")

    def test_changes_the_colours_of_the_goals_at_half_time(self):
        self.assertEqual(self.goals(), [[True, False], [False, True]])
        self.leave_picture("first_half")
        self.seek_second_half()
        self.assertEqual(self.goals(), [[False, True], [True, False]])
        self.leave_picture("second_half")
        self.press(Keys.HOME)
        self.assertEqual(self.goals(), [[True, False], [False, True]])

    def test_shows_the_teams_at_their_current_ends(self):
        mean_x = """
            const scene = page.recording.sceneAt(page.player.time_s);
            return [0, 1].map((side) => {
              const own = scene.robots.filter((robot) => robot.side === side);
              return own.reduce((sum, robot) => sum + robot.x, 0) / own.length;
            });"""
        yellow, blue = self.browser.execute_script(mean_x)
        self.assertLess(yellow, 0)
        self.assertGreater(blue, 0)
        self.seek_second_half()
        yellow, blue = self.browser.execute_script(mean_x)
        self.assertGreater(yellow, 0)
        self.assertLess(blue, 0)

    def test_shows_no_speed_of_robots_that_change_ends(self):
        fastest = self.browser.execute_script(
            """
            const {recording} = page;
            const turn = recording.yellowEnds.indexOf(1);
            let fastest = 0;
            for (let i = turn - 5; i < turn + 5; ++i) {
              for (const robot of recording.robots)
                fastest = Math.max(fastest, velocityAt(recording, robot, i)?.speed ?? 0);
            }
            return fastest;"""
        )
        self.assertLess(fastest, 4000)


class KilledGamePageTest(GamePage):
    """A game that was played in parts until the program was killed while it wrote the last one."""

    settings = {"a__strategy": "cobalt1", "b__strategy": "chaser", "match__half_s": 20, "match__rules": "2026-b"}

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.whole = cls.page
        cls.page = cls.whole.with_name("killed.html")
        chosen = [
            word for key, value in cls.settings.items() for word in ("--set", f"{key.replace('__', '.')}={value}")
        ]
        ports = ["--control-port", "0", "--grsim-port", "0"]
        live = [cls.autoref, "live", cls.scenario, *chosen, "--speed", "max", "--unicast", "127.0.0.77", *ports]
        with subprocess.Popen(
            [*live, "--view", str(cls.page)], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
        ) as game:
            while game.poll() is None:
                if cls.page.exists() and cls.page.read_bytes().count(b"</script>") > 60:
                    game.kill()
        with cls.page.open("a") as file:
            file.write('<script type="application/json" class="part">{"frames": 60, "ro')

    def recorded(self, expression):
        return self.browser.execute_script(f"return {expression}")

    def test_loads_without_complaints(self):
        self.assertEqual(self.browser.get_log("browser"), [])

    def test_shows_the_same_as_the_page_of_the_whole_game(self):
        last_s = self.recorded("page.recording.last_s")
        self.assertGreater(last_s, 50)
        lists = "[page.game.signals, page.game.decisions, page.game.chains, page.game.shots]"
        known = f"{lists}.map((list) => list.filter((one) => (one.time_s ?? 0) < {last_s}))"
        at = [last_s * share for share in (0.013, 0.2, 0.5, 0.77, 0.99)]
        scenes = f"{at}.map((time_s) => page.recording.sceneAt(time_s))"
        parts, scenes_in_parts = self.recorded(known), self.recorded(scenes)
        self.press(Keys.END)
        self.leave_picture("killed")
        self.browser.get(self.whole.as_uri())
        whole, scenes_in_whole = self.recorded(known), self.recorded(scenes)
        self.assertEqual(parts[:2], whole[:2])
        for chains_or_shots, of_whole in zip(parts[2:], whole[2:]):
            self.assertEqual(chains_or_shots, of_whole[: len(chains_or_shots)])
        for scene in (*scenes_in_parts, *scenes_in_whole):
            scene["robots"].sort(key=lambda robot: (robot["side"], robot["number"]))
        self.assertEqual(scenes_in_parts, scenes_in_whole)


class FoulPageTest(GamePage):
    """A game full of fouls and cards."""

    settings = {"match__rules": "2026-b", "match__half_s": 120, "a__strategy": "rowdy", "seed": 2}

    def test_names_sides_by_their_colours_only(self):
        text = self.browser.execute_script("return document.body.innerText")
        self.assertIsNone(re.search(r"\b(west|east)\b", text, re.IGNORECASE))
        self.assertIn("blue", text)

    def test_has_no_negative_distances(self):
        text = " ".join(self.texts(".highlight"))
        self.assertIsNone(re.search(r"-[\d.]+ mm", text))

    def test_says_why_a_card_is_yellow_or_red(self):
        titles = self.texts(".highlight.card .title")
        self.assertTrue(titles)
        for title in titles:
            self.assertRegex(title, r"^(Yellow|Red) card for (yellow|blue|each side): \d+(st|nd|rd|th) foul")
        for title in self.texts(".highlight.card[data-color=red] .title"):
            self.assertTrue(title.endswith("red because it would be the 3rd active yellow card"), title)

    def test_shows_the_whole_reason_of_a_card_on_a_phone(self):
        self.show(PHONE)
        self.browser.execute_script("document.querySelector('.highlight.card[data-color=red]').click()")
        self.settle()
        self.leave_picture("card_phone")
        self.assertEqual(self.cut_off(), [])
        for name in ("call", "callTitle"):
            box = self.browser.find_element(By.ID, name)
            self.assertLessEqual(box.get_property("scrollHeight"), box.get_property("clientHeight") + 1)
            self.assertLessEqual(box.get_property("scrollWidth"), PHONE[0])


class ComparedPageTest(BrowserTest):
    """The page of a log with the calls of both referees, recorded and AutoRef's."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        log, cls.page = str(pathlib.Path(folder.name) / "game.log"), pathlib.Path(folder.name) / "both.html"
        played_game(
            GamePage.autoref,
            GamePage.scenario,
            str(cls.page),
            match__half_s=60,
            a__strategy="cobalt1",
            b__strategy="cobalt1",
            log=log,
        )
        mine, cls.annotated_page = pathlib.Path(folder.name) / "mine.csv", pathlib.Path(folder.name) / "mine.html"
        mine.write_text("time,call,side\n20,goal,yellow\n")
        done = subprocess.run(
            [GamePage.autoref, "referee", "log", log, "--report", str(cls.page), "--json"],
            check=True,
            capture_output=True,
            text=True,
            timeout=300,
        )
        cls.compared = json.loads(done.stdout)
        done = subprocess.run(
            [
                GamePage.autoref,
                "referee",
                log,
                "--annotations",
                str(mine),
                "--json",
                "--report",
                str(cls.annotated_page),
            ],
            check=True,
            capture_output=True,
            text=True,
            timeout=300,
        )
        cls.annotated = json.loads(done.stdout)

    def setUp(self):
        self.show(DESKTOP)

    def marks(self, kind):
        return self.browser.find_elements(By.CSS_SELECTOR, f".mark.recorded{kind}")

    def test_marks_each_recorded_call(self):
        self.browser.get(self.page.as_uri())
        self.settle()
        self.assertEqual(self.browser.get_log("browser"), [])
        self.assertGreater(self.compared["recorded"], 2)
        self.assertEqual(len(self.marks(".missed")), self.compared["recorded"] - self.compared["right"])
        self.leave_picture("compared")

    def disagreements(self, compared):
        return compared["recorded"] + compared["judged"] - 2 * compared["right"]

    def test_lists_a_call_of_both_referees_once(self):
        self.browser.get(self.page.as_uri())
        self.settle()
        self.assertGreater(self.compared["right"], 2)
        titles, reasons = self.texts(".highlight .title"), self.texts(".highlight .reason")
        agreed = [reason for reason in reasons if re.search(r"Recorded: (?!nothing)[^.]+\.$", reason)]
        self.assertEqual(len(agreed), self.compared["right"])
        recorded = [title for title in titles if title.startswith("Recorded: ")]
        self.assertEqual(len(recorded), self.compared["recorded"] - self.compared["right"])
        self.assertTrue(any(title.startswith("Both: ") for title in titles))
        self.assertEqual(len(self.texts(".highlight.disagreement")), self.disagreements(self.compared))

    def test_lists_only_disagreements_if_asked(self):
        self.browser.get(self.annotated_page.as_uri())
        self.settle()

        def listed():
            return [one for one in self.browser.find_elements(By.CSS_SELECTOR, ".highlight") if one.is_displayed()]

        everything = len(listed())
        disagreements = self.disagreements(self.annotated)
        self.assertGreater(disagreements, 0)
        self.browser.find_element(By.ID, "disagreements").click()
        self.settle()
        self.assertEqual(len(listed()), disagreements)
        self.leave_picture("disagreements")
        self.browser.find_element(By.TAG_NAME, "body").send_keys("n")
        self.settle()
        self.assertEqual(self.texts(".highlight.disagreement .when")[0], self.text("time").split(".")[0])
        self.browser.find_element(By.TAG_NAME, "body").send_keys("d")
        self.settle()
        self.assertEqual(len(listed()), everything)

    def test_has_no_filter_without_a_comparison(self):
        page = self.annotated_page.with_name("plain.html")
        played_game(GamePage.autoref, GamePage.scenario, str(page), match__half_s=5)
        self.browser.get(page.as_uri())
        self.settle()
        self.assertFalse(self.browser.find_element(By.ID, "disagreements").is_displayed())

    def test_shows_the_chains_of_the_log_but_no_win_probability(self):
        self.browser.get(self.page.as_uri())
        self.settle()
        self.browser.find_element(By.TAG_NAME, "body").send_keys("67c")
        self.settle()
        self.assertNotEqual(self.text("time"), "0:00.00")
        self.assertIn(", worth ", self.text("chain"))
        for name in ("chainStrip", "chainStart", "layer-shots", "layer-losses", "xg"):
            self.assertTrue(self.browser.find_element(By.ID, name).is_displayed(), name)
        self.assertGreater(len(self.browser.find_elements(By.CSS_SELECTOR, "#paths line")), 5)
        for name in ("winChart", "win", "turningPoints"):
            self.assertFalse(self.browser.find_element(By.ID, name).is_displayed(), name)
        self.leave_picture("log-chains")
        self.assertEqual(self.browser.get_log("browser"), [])

    def test_marks_what_was_missed_and_opens_at_that_moment(self):
        missed = [call for call in self.annotated["calls"] if call["recorded"]]
        self.assertEqual([call["recorded"]["event"] for call in missed], ["goal"])
        moment = missed[0]["moment"].rpartition("#")[2]
        self.assertEqual(moment, "t=20.00")
        self.browser.get(self.annotated_page.as_uri() + "#" + moment)
        self.settle()
        self.assertEqual(len(self.marks(".missed")), 1)
        self.assertEqual(self.text("time"), "0:20.00")
        self.assertIn("Recorded: goal (yellow)", self.text("callTitle"))


if __name__ == "__main__":
    GamePage.scenario, GamePage.autoref = sys.argv.pop(), sys.argv.pop()
    unittest.main(verbosity=2)
