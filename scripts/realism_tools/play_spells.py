"""When play was on, from the lines that autoref writes with --events."""

_ENDS_OF_HALVES = ("half_over", "game_over")


def spells_of_play(decisions):
    """Times (begin_s, end_s) from each restart's signal until the referee ended play."""
    spells, begin_s = [], None
    for decision in decisions:
        if decision["to"] == "RUN" and begin_s is None:
            begin_s = decision["time_s"]
        elif decision["to"] != "RUN" and begin_s is not None:
            spells.append((begin_s, decision["time_s"]))
            begin_s = None
    return spells


def number_of_stops(decisions):
    """How often the referee ended play, without the ends of halves."""
    return sum(
        decision["from"] == "RUN" and decision["to"] != "RUN" and decision["transition"] not in _ENDS_OF_HALVES
        for decision in decisions
    )


def periods_without_halt(decisions, end_s):
    """Times (begin_s, end_s) in which the last command was not HALT."""
    periods, begin_s = [], 0.0
    for decision in decisions:
        if decision["command"] == "HALT" and begin_s is not None:
            periods.append((begin_s, decision["time_s"]))
            begin_s = None
        elif decision["command"] not in (None, "HALT") and begin_s is None:
            begin_s = decision["time_s"]
    return periods if begin_s is None else periods + [(begin_s, end_s)]


def length_s(periods):
    return sum(end_s - begin_s for begin_s, end_s in periods)
