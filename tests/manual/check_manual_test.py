#!/usr/bin/env python3
"""scripts/check-manual finds commands that fail, outputs that differ, and pages that cannot be read; the site's
checks find links that lead nowhere. A copy of the scripts checks small pages with a program that prints its arguments.

    check_manual_test.py CHECKOUT
"""

import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

CHECKOUT = pathlib.Path(sys.argv.pop(1)).resolve()


class Case(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        shutil.copytree(
            CHECKOUT / "scripts" / "manual_tools",
            self.root / "scripts" / "manual_tools",
            ignore=shutil.ignore_patterns("__pycache__"),
        )
        shutil.copy(CHECKOUT / "scripts" / "check-manual", self.root / "scripts")
        self.program = self.root / "program" / "bin" / "autoref"
        self.program.parent.mkdir(parents=True)
        self.program.write_text('#!/usr/bin/env bash\necho "$@"\n')
        self.program.chmod(0o755)

    def check(self, *lines, options=()):
        """Exit code and output of check-manual for a page of these lines."""
        (self.root / "page.md").write_text("\n".join(lines) + "\n", encoding="utf-8")
        done = subprocess.run(
            [self.root / "scripts" / "check-manual", "--program", self.program, *options, "page.md"],
            capture_output=True,
            text=True,
            check=False,
        )
        return done.returncode, done.stdout + done.stderr

    def assert_fails(self, expected, *lines, options=()):
        code, output = self.check(*lines, options=options)
        self.assertEqual(code, 1, output)
        self.assertIn(expected, output)

    def assert_passes(self, *lines, options=()):
        code, output = self.check(*lines, options=options)
        self.assertEqual(code, 0, output)
        return output


class Commands(Case):
    def test_of_a_page_share_folder_and_variables(self):
        self.assert_passes(
            "```sh",
            "mkdir new && cd new",
            "export X=1",
            "```",
            "```sh",
            'cd ../new && [[ "$X" == 1 ]]',
            "build=1; ../build/release/bin/autoref",
            "```",
        )

    def test_that_fail_are_named_with_their_output(self):
        self.assert_fails("page.md:5: exit code 3", "```sh", "true", "```", "", "```sh", "echo why", "(exit 3)", "```")
        self.assert_fails("    why", "```sh", "echo why", "false", "```")

    def test_find_the_program_with_and_without_its_folder(self):
        self.assert_passes("```sh", "autoref log info", "build/release/bin/autoref log info", "```")

    def test_that_cannot_be_run_are_counted_with_their_reason(self):
        output = self.assert_passes("<!-- not run: needs a robot -->", "```sh", "false", "```")
        self.assertIn("1 not run", output)
        self.assertIn("page.md:2: needs a robot", output)

    def test_are_shortened_where_games_are_played(self):
        self.assert_passes(
            "<!-- run shortened: --pairs 1 -->",
            "```sh",
            "autoref run x",
            "autoref report x",
            "```",
            "<!-- output -->",
            "```",
            "run x --pairs 1",
            "report x",
            "```",
        )

    def test_that_run_for_ever_are_interrupted(self):
        self.assert_passes("<!-- run for: 1 s -->", "```sh", "sleep 100", "```")
        self.assert_fails("exit code 2", "<!-- run for: 60 s -->", "```sh", "exit 2", "```")

    def test_find_the_files_of_the_page_and_what_is_prepared(self):
        self.assert_passes(
            "<!-- file: a/b.txt -->",
            "```yaml",
            "x: 1",
            "```",
            "<!-- first: cp a/b.txt c.txt -->",
            "<!-- first: cp c.txt d.txt -->",
            "```sh",
            "grep x d.txt",
            "```",
        )

    def test_do_not_change_the_checkout(self):
        self.assert_passes("```sh", "touch page.md new", "```")
        self.assertFalse((self.root / "new").exists())


class Outputs(Case):
    def test_may_differ_in_numbers_only(self):
        page = ["```sh", "echo took 1.5 s, state 0123456789abcdef", "```", "<!-- output -->", "```"]
        self.assert_passes(*page, "took  22 s, state fedcba9876543210", "```")
        self.assert_passes(*page, "took ...", "```")
        self.assert_fails("page.md:5: not printed like this: lasted 1.5 s", *page, "lasted 1.5 s", "```")


class AtFullLength(Case):
    FULL = ("--full",)

    def test_nothing_is_shortened(self):
        lines = ["<!-- run shortened: --pairs 1 -->", "```sh", "autoref run x", "```", "<!-- output -->", "```"]
        self.assert_passes(*lines, "run x", "```", options=self.FULL)
        self.assert_fails("not printed like this: run x --pairs 1", *lines, "run x --pairs 1", "```", options=self.FULL)

    def test_long_commands_are_left_out_if_they_say_why(self):
        lines = ["<!-- only shortened: takes an hour -->", "```sh", "false", "```"]
        self.assert_passes(*lines, options=self.FULL)
        self.assert_fails("exit code 1", *lines)

    def test_numbers_count_but_not_spaces(self):
        lines = ["```sh", "echo 'score   3 : 1 in 0.7 s'", "```", "<!-- output -->", "```"]
        self.assert_passes(*lines, "score 3 : 1 in ...", "```", options=self.FULL)
        self.assert_fails(
            "not printed like this: score 3 : 2 in ...", *lines, "score 3 : 2 in ...", "```", options=self.FULL
        )

    def test_outputs_of_that_length_are_compared(self):
        lines = ["```sh", "echo no", "```", "<!-- output: at full length -->", "```", "yes", "```"]
        self.assert_passes(*lines)
        self.assert_fails("not printed like this: yes", *lines, options=self.FULL)

    def test_quoted_numbers_are_printed(self):
        lines = ["```sh", "echo 'zone 83 points, +2.65'", "```", "", "<!-- quotes the output -->"]
        self.assert_passes(*lines, "Zone leads by 2.65 goals.", "", "In 2014.", options=self.FULL)
        self.assert_fails("page.md:5: 74 is not printed", *lines, "Zone has 83 points,", "basic 74.", options=self.FULL)
        self.assert_passes(*lines, "Zone has 74 points.")


class Pages(Case):
    def test_with_unknown_marks_are_refused(self):
        self.assert_fails("unknown mark 'skip'", "<!-- skip -->", "```sh", "true", "```")
        self.assert_fails("needs a value", "<!-- not run: -->", "```sh", "true", "```")
        self.assert_fails("needs a value", "<!-- from: -->", "```", "a table", "```")
        self.assert_passes("<!-- from: games/table.txt -->", "```", "a table", "```")

    def test_with_hidden_or_open_blocks_are_refused(self):
        self.assert_fails("must not be indented", "- item", "  ```sh", "  true", "  ```")
        self.assert_fails("not closed", "```sh", "true")

    def test_need_a_script_for_each_picture(self):
        (self.root / "scripts" / "draw").touch()
        self.assert_fails("a.png has no comment", "![A](a.png)")
        self.assert_fails("a.png has no comment", "<!-- drawn by: scripts/gone -->", "![A](a.png)")
        self.assert_passes("<!-- drawn by: scripts/draw all -->", "![A](a.png)")


class Links(Case):
    def problems(self, *pages):
        site = self.root / "site"
        site.mkdir(exist_ok=True)
        for number, text in enumerate(pages):
            (site / f"{number}.html").write_text(text, encoding="utf-8")
        checker = self.root / "scripts" / "manual_tools" / "check_links.py"
        return subprocess.run(["python3", checker, site], capture_output=True, text=True, check=False).stderr

    def test_lead_to_files_and_anchors(self):
        self.assertEqual(self.problems('<a href="1.html#x">', '<h1 id="x"><a href="0.html">'), "")
        self.assertIn("0.html: 2.html leads nowhere", self.problems('<a href="2.html">'))
        self.assertIn("anchor that is not there", self.problems('<a href="1.html#y">', '<h1 id="x">'))
        self.assertIn("leads nowhere", self.problems('<a href="../page.md">'))

    def test_load_nothing_from_the_network(self):
        self.assertIn("is loaded from the network", self.problems('<script src="https://a.b/c.js"></script>'))
        self.assertEqual(self.problems('<a href="https://a.b/">'), "")


if __name__ == "__main__":
    unittest.main()
