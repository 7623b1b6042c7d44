#!/usr/bin/env python3
"""Checks a built site:  check_links.py FOLDER

Every link leads to a file of the site, and to an anchor in it if it names one; nothing is loaded from the network."""

import html.parser
import pathlib
import re
import sys
import urllib.parse

EXTERNAL = re.compile(r"\w+:|//")
LOADED = {"script": "src", "img": "src", "link": "href", "iframe": "src"}


class Page(html.parser.HTMLParser):
    """Collects a page's links, anchors, and what it loads."""

    def __init__(self, text):
        super().__init__()
        self.links, self.anchors, self.loaded = [], set(), []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        self.anchors.update(values[name] for name in ("id", "name") if values.get(name))
        if tag in LOADED and values.get(LOADED[tag]):
            self.loaded.append(values[LOADED[tag]])
        if tag == "a" and values.get("href"):
            self.links.append(values["href"])


def problem_of(file, link, pages, folder):
    """What is wrong with a link of a page; None if nothing is."""
    path, _, anchor = link.partition("#")
    target = (file.parent / urllib.parse.unquote(path)).resolve() if path else file
    if target.is_dir():
        target = target / "index.html"
    if not target.is_file() or folder not in target.parents:
        return "leads nowhere"
    if anchor and target in pages and urllib.parse.unquote(anchor) not in pages[target].anchors:
        return "names an anchor that is not there"
    return None


def problems_of(file, page, pages, folder):
    for link in page.loaded:
        if EXTERNAL.match(link) and not link.startswith("data:"):
            yield f"{link} is loaded from the network"
    for link in page.links + [link for link in page.loaded if not EXTERNAL.match(link)]:
        link = link.split("?")[0]
        if not EXTERNAL.match(link) and link != "#":
            problem = problem_of(file, link, pages, folder)
            if problem:
                yield f"{link} {problem}"


def main(folder):
    files = [file for file in sorted(folder.rglob("*.html")) if file.name != "404.html"]
    if not files:
        sys.exit(f"check_links: {folder} has no pages")
    pages = {file: Page(file.read_text(encoding="utf-8")) for file in files}
    failed = False
    for file, page in pages.items():
        for problem in problems_of(file, page, pages, folder):
            print(f"{file.relative_to(folder)}: {problem}", file=sys.stderr)
            failed = True
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve()))
