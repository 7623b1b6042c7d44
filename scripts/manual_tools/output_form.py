"""Compares what commands print with what a page says, with or without the numbers."""

import re

NUMBER = re.compile(r"[-+<]?\d+(?:[.:]\d+)*")
QUOTED = re.compile(r"\d+(?:[.:]\d+)*")
HASH = re.compile(r"\b[0-9a-f]{12,16}\b")


def form_of(line):
    """The line with every hash and number replaced, and spaces joined."""
    return " ".join(NUMBER.sub("N", HASH.sub("H", line)).split())


def spaced(line):
    """The line with spaces joined."""
    return " ".join(line.split())


def pattern_of(line, form):
    """Matches lines of this form; "..." stands for anything."""
    return re.compile(".*".join(re.escape(form(part)) for part in line.split("...")))


def missing_numbers(text, printed):
    """The numbers of a page's text that are not printed."""
    numbers = set(QUOTED.findall(printed))
    return [number for number in QUOTED.findall(text) if number not in numbers]


def missing_lines(shown, printed, exact=False):
    """The lines of a page's block that no printed line looks like, or is, if the numbers count."""
    form = spaced if exact else form_of
    forms = {form(line) for line in printed.splitlines()}
    missing = []
    for line in shown.splitlines():
        pattern = pattern_of(line, form)
        if line.strip() and not any(pattern.fullmatch(form) for form in forms):
            missing.append(line)
    return missing
