"""Draws the state diagrams of the pages, which Git hosts draw themselves, with graphviz."""

import re
import subprocess

TRANSITION = re.compile(r"\s*(\S+) --> (\S+?)(?:: (.*))?$")


def transitions_of(diagram):
    """Labels by the states that they lead from and to."""
    transitions = {}
    for line in diagram.splitlines()[1:]:
        found = TRANSITION.match(line)
        if not found:
            raise ValueError(f"expected a transition between states, found '{line}'")
        transitions.setdefault((found[1], found[2]), []).append(found[3] or "")
    return transitions


def graph_of(diagram):
    lines = [
        "digraph {",
        "rankdir=TB; node [shape=box, style=rounded, fontname=Helvetica];",
        "edge [fontname=Helvetica, fontsize=11];",
        '"[*]" [shape=point, width=0.15, label=""];',
    ]
    for (start, end), labels in transitions_of(diagram).items():
        text = "\\l".join(labels) + "\\l" if any(labels) else ""
        lines.append(f'"{start}" -> "{end}" [label="{text}"];')
    return "\n".join(lines) + "\n}\n"


def svg_of(diagram):
    """The diagram as an SVG element."""
    drawn = subprocess.run(["dot", "-Tsvg"], input=graph_of(diagram), capture_output=True, text=True, check=True)
    return drawn.stdout[drawn.stdout.index("<svg") :]
