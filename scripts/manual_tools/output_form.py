"""Compares what commands print with what a page says, except for the numbers."""

import re

NUMBER = re.compile(r"[-+<]?\d+(?:[.:]\d+)*")
HASH = re.compile(r"\b[0-9a-f]{12,16}\b")


def form_of(line):
    """The line with every hash and number replaced, and spaces joined."""
    return " ".join(NUMBER.sub("N", HASH.sub("H", line)).split())


def pattern_of(line):
    """Matches lines of this form; "..." stands for anything."""
    return re.compile(".*".join(re.escape(form_of(part)) for part in line.split("...")))


def missing_lines(shown, printed):
    """The lines of a page's block that no printed line looks like."""
    forms = {form_of(line) for line in printed.splitlines()}
    missing = []
    for line in shown.splitlines():
        pattern = pattern_of(line)
        if line.strip() and not any(pattern.fullmatch(form) for form in forms):
            missing.append(line)
    return missing
