"""The fenced blocks of the manual's pages, and the marks before them."""

import dataclasses
import pathlib
import re
import shlex

COMMENT = re.compile(r"<!-- (.*?) -->$")
FENCE = re.compile(r"(```+)(\w*)$")


class PageError(Exception):
    """A page that cannot be read; says where and why."""


@dataclasses.dataclass
class Block:
    page: str
    line: int
    language: str  # "sh" for commands
    text: str
    marks: dict[str, str]  # by kind, see KINDS

    @property
    def where(self):
        return f"{self.page}:{self.line}"

    @property
    def is_commands(self):
        return self.language == "sh"


# The marks allowed in a comment directly before a block, and the blocks to which they apply.
KINDS = {
    "not run": "sh",  # the reason
    "run shortened": "sh",  # options added to verbs that play games
    "only shortened": "sh",  # the reason why it is not run at full length
    "run for": "sh",  # "5 s": then interrupted, as with Ctrl-C
    "first": "sh",  # a command that is run before and not shown
    "file": "",  # the block is a file of this name, for the commands that follow
    "output": "",  # the block is the output of the commands before it
    "from": "",  # the block is part of this committed file, relative to the page (see tests/python/test_handicaps.py)
}


def mark_of(comment, where):
    kind, _, value = comment.partition(":")
    if kind.strip() not in KINDS:
        raise PageError(f"{where}: unknown mark '{comment}'; expected one of {', '.join(KINDS)}")
    return kind.strip(), value.strip()


def marks_before(lines, index, page):
    """The marks in the comments directly before lines[index], from the top down."""
    marks = {}
    while index > 0 and (found := COMMENT.match(lines[index - 1])):
        kind, value = mark_of(found[1], f"{page}:{index}")
        if kind in marks:  # several commands to run first
            value += "\n" + marks[kind]
        marks = marks | {kind: value}
        index -= 1
    return marks


def check(block):
    for kind, value in block.marks.items():
        if (KINDS[kind] == "sh") != block.is_commands:
            raise PageError(f"{block.where}: the mark '{kind}' does not fit this block")
        if kind == "output" and value not in ("", "at full length"):
            raise PageError(f"{block.where}: expected 'output' or 'output: at full length'")
        if not value and kind != "output":
            raise PageError(f"{block.where}: the mark '{kind}' needs a value after the colon")
    if "run for" in block.marks and not re.fullmatch(r"[1-9]\d? s", block.marks["run for"]):
        raise PageError(f"{block.where}: expected 'run for: 5 s', at most 99 s")
    shlex.split(block.marks.get("run shortened", ""))


def blocks_of(root, page):
    """All fenced blocks of a page, which is given from the checkout's root."""
    lines = pathlib.Path(root, page).read_text(encoding="utf-8").splitlines()
    blocks = []
    index = 0
    while index < len(lines):
        if re.match(r"\s+```+sh$", lines[index]):
            raise PageError(f"{page}:{index + 1}: blocks must not be indented, or their commands are not run")
        fence = FENCE.match(lines[index])
        if not fence:
            index += 1
            continue
        end = next((i for i in range(index + 1, len(lines)) if lines[i] == fence[1]), None)
        if end is None:
            raise PageError(f"{page}:{index + 1}: the block is not closed")
        text = "\n".join(lines[index + 1 : end]) + "\n"
        blocks.append(Block(page, index + 1, fence[2], text, marks_before(lines, index, page)))
        check(blocks[-1])
        index = end + 1
    return blocks


QUOTES = "<!-- quotes the output -->"


def quoting_paragraphs(root, page):
    """The line and the text of each paragraph whose numbers are those of the output before it."""
    lines = pathlib.Path(root, page).read_text(encoding="utf-8").splitlines()
    for index, line in enumerate(lines):
        if line == QUOTES:
            end = next((i for i in range(index + 1, len(lines)) if not lines[i].strip()), len(lines))
            yield index + 1, " ".join(lines[index + 1 : end])


PICTURE = re.compile(r"!\[[^\]]*\]\(([^)]+)\)")
DRAWN_BY = re.compile(r"<!-- drawn by: (\S+)( .*)? -->$")


def pictures_without_command(root, page):
    """Pictures that no comment in the line before says how to draw, by a script of the checkout."""
    lines = pathlib.Path(root, page).read_text(encoding="utf-8").splitlines()
    for before, line in zip(["", *lines], lines):
        drawn = DRAWN_BY.match(before)
        if PICTURE.match(line) and not (drawn and pathlib.Path(root, drawn[1]).is_file()):
            yield PICTURE.match(line)[1]


# Folders whose pages are not part of the manual: teams' templates, and the output of programs.
OUTSIDE = re.compile(r"(build|results/runs|game/team_programs|tests|scripts|\.[^/]*)/")


def all_pages(root):
    """All pages of the manual, the front page first."""
    pages = [str(path.relative_to(root)) for path in pathlib.Path(root).rglob("*.md")]
    return sorted((p for p in pages if not OUTSIDE.match(p)), key=lambda p: (p.count("/"), p))
