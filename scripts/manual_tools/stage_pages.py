#!/usr/bin/env python3
"""Copies the pages of the checkout for mkdocs:  stage_pages.py FOLDER

The pages are written for Git hosts, and mkdocs reads another dialect of Markdown. The copies keep their places, so
that their links hold; what they link to besides pages is copied as it is (pictures) or as a page of text (sources)."""

import html
import os
import pathlib
import re
import shutil
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import blocks as manual  # noqa: E402
import machine_figure  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PICTURES = {".png", ".svg", ".jpg"}
JQUERY = "/usr/share/javascript/jquery/jquery.min.js"  # of libjs-jquery, which mkdocs needs
LINK = re.compile(r"(\]\()([^)\s#]+)(#[^)\s]*)?(\))")
ITEM = re.compile(r"\s*([-*+]|\d+\.) ")

SOURCE = """<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<title>{name}</title><style>body {{ margin: 1em; font-family: sans-serif }} pre {{ overflow-x: auto }}</style></head>
<body><p><a href="{home}">AutoRef</a> / {name}</p>
<pre>{text}</pre></body></html>
"""


def listing_of(folder):
    return "\n".join(sorted(entry.name + "/" * entry.is_dir() for entry in folder.iterdir()))


def write_source(source, target):
    """A page that shows a source file, or lists a folder."""
    target.parent.mkdir(parents=True, exist_ok=True)
    name = str(source.relative_to(ROOT))
    text = listing_of(source) if source.is_dir() else source.read_text(encoding="utf-8")
    home = "../" * (len(target.relative_to(STAGE).parts) - 1) + "index.html"
    target.write_text(SOURCE.format(name=name, home=home, text=html.escape(text)), encoding="utf-8")


def staged_link(page, target):
    """Where a page's link leads in the site; copies what it leads to."""
    if re.match(r"\w+:", target):
        return target
    source = pathlib.Path(os.path.normpath(ROOT / os.path.dirname(page) / target))
    if not source.exists():
        raise manual.PageError(f"{page}: the link to {target} leads nowhere")
    name = source.relative_to(ROOT)
    if str(name) in PAGES:
        return target
    if source.suffix in PICTURES:
        (STAGE / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(source, STAGE / name)
        return target
    write_source(source, STAGE / f"{name}.html")
    return target.rstrip("/") + ".html"


def with_links(page, line):
    """The line with its links as in the site, except in code."""
    parts = re.split(r"(`[^`]*`)", line)
    for i, part in enumerate(parts):
        if i % 2 == 0:
            parts[i] = LINK.sub(lambda m: m[1] + staged_link(page, m[2]) + (m[3] or "") + m[4], part)
    return "".join(parts)


def staged_text(lines):
    """Lists and tables are set apart by blank lines, and lists within lists by four spaces."""
    before, is_list = "", False
    for line in lines:
        is_item = bool(ITEM.match(line))
        is_list = is_item or (is_list and (not line or line.startswith(" ")))
        if is_list and re.match(r" {2,3}\S", line):
            line = "    " + line.lstrip()
        begins = is_item and not is_list_line(before) or line.startswith("|") and not before.startswith("|")
        if begins and before:
            yield ""
        yield line
        before = line


def is_list_line(line):
    return bool(ITEM.match(line)) or line.startswith("  ")


def staged_block(fence, body):
    """A fenced block; within lists it is indented instead."""
    indent = len(fence) - len(fence.lstrip())
    if indent:
        return ["", *(" " * 8 + line[indent:] for line in body), ""]
    if fence == "```mermaid":
        return ['<div class="diagram">', machine_figure.svg_of("\n".join(body)), "</div>", ""]
    return ["", fence, *body, "```", ""]


def staged_page(page):
    lines = (ROOT / page).read_text(encoding="utf-8").splitlines()
    staged, text, index = [], [], 0
    while index < len(lines):
        if manual.COMMENT.match(lines[index]):
            index += 1  # marks of check-manual and commands of pictures
        elif lines[index].lstrip().startswith("```"):
            end = next(i for i in range(index + 1, len(lines)) if lines[i].strip() == "```")
            staged += [*staged_text(text), *staged_block(lines[index], lines[index + 1 : end])]
            text, index = [], end + 1
        else:
            text.append(with_links(page, lines[index]))
            index += 1
    return "\n".join([*staged, *staged_text(text)]) + "\n"


def add_theme_files():
    """Our style, and two files that Debian's copy of the theme asks for but lacks."""
    tools = pathlib.Path(__file__).resolve().parent
    shutil.copy(tools / "manual.css", STAGE)
    (STAGE / "js").mkdir()
    shutil.copy(tools / "theme_extra.js", STAGE / "js")
    shutil.copy(JQUERY, STAGE / "js" / "jquery-3.6.0.min.js")


def main():
    shutil.rmtree(STAGE, ignore_errors=True)
    for page in PAGES:
        target = STAGE / page
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(staged_page(page), encoding="utf-8")
    add_theme_files()
    for page in sorted(PAGES - set(re.findall(r"(\S+\.md)$", (ROOT / "mkdocs.yml").read_text(), re.MULTILINE))):
        print(f"manual: {page} is missing from the navigation in mkdocs.yml", file=sys.stderr)


if __name__ == "__main__":
    STAGE = pathlib.Path(sys.argv[1]).resolve()
    PAGES = set(manual.all_pages(ROOT))
    try:
        main()
    except (manual.PageError, ValueError, OSError) as error:
        sys.exit(f"manual: {error}")
