"""A game of `autoref live` with programs on its network, for the tests."""
import json
import pathlib
import re
import subprocess
import tempfile

FOLDER = pathlib.Path(__file__).resolve().parent
LONGEST_S = 240
PACKETS = re.compile(r"^(yellow|blue): (\d+) packets, (\d+) invalid", re.MULTILINE)


class LiveGame:
    """A running simulator whose teams are both commanded over the network."""

    def __init__(self, autoref, scenario, *arguments, half_s, settings=()):
        self.autoref = autoref
        self.settings = [scenario]
        always = "match.rules=2026-b", "a.strategy=network", "b.strategy=network", f"match.half_s={half_s}"
        for setting in (*always, *settings):
            self.settings += ["--set", setting]
        self.folder = tempfile.TemporaryDirectory()
        self.record = pathlib.Path(self.folder.name) / "commands.gz"
        self.arguments = arguments
        self.programs = []

    def __enter__(self):
        command = [self.autoref, "live", *self.settings, *self.arguments, "--record", self.record, "--json"]
        self.process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        return self

    def __exit__(self, *_):
        for program in [self.process, *self.programs]:
            if program.poll() is None:
                program.kill()
            program.communicate()
        self.folder.cleanup()

    def start(self, name, *arguments):
        """Starts a program of this folder; some run until their input ends."""
        pipes = dict(stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        program = subprocess.Popen([FOLDER / name, *arguments], **pipes)
        self.programs.append(program)
        return program

    def result(self):
        """The game's result, and what was printed about the packets."""
        output, self.report = self.process.communicate(timeout=LONGEST_S)
        assert self.process.returncode == 0, self.report
        result = json.loads(output)
        assert result["status"] == "ok", result["void_reason"]
        return result

    def packets(self):
        """Packets that the simulator counted, by team."""
        return {team: int(count) for team, count, _ in PACKETS.findall(self.report)}

    def wrong_packets(self):
        """Those that it counted as wrong."""
        return {team: int(wrong) for team, _, wrong in PACKETS.findall(self.report)}

    def replayed(self):
        """The result of the same game with the recorded commands."""
        command = [self.autoref, "play", *self.settings, "--commands", self.record, "--json"]
        return json.loads(subprocess.run(command, stdout=subprocess.PIPE, check=True, timeout=LONGEST_S).stdout)


def are_answered(counts, teams=2):
    """Whether the simulator answered every packet, except perhaps the last one of each team, when the game ended."""
    return 0 <= counts["sent"] - counts["answers"] <= teams


def counted(program):
    """What a program printed when the game was over."""
    output, _ = program.communicate(timeout=LONGEST_S)
    assert program.returncode == 0, f"{program.args} failed"
    return json.loads(output)
