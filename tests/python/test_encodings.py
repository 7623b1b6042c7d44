"""The encodings contain the same values, and answers arrive as they were sent.

TEAM_SAMPLES is the program of that name in the build: it writes random messages and reads answers.
"""
import io
import os
import random
import subprocess
import unittest

from autoref.messages import Command, End, Output, Play, Start, View
from autoref.team import codec_of

_SAMPLES = os.environ.get("TEAM_SAMPLES", "")
_ENCODINGS = ["flat", "json"]


def _bits(value):
    """The value with its doubles in hexadecimal, which shows every bit."""
    if isinstance(value, float):
        return value.hex()
    if isinstance(value, (list, tuple)):
        return [_bits(element) for element in value]
    if isinstance(value, dict):
        return {name: _bits(element) for name, element in value.items()}
    return value


def _members(message):
    """All values of a message."""
    names = [name for name in type(message).__dataclass_fields__ if not name.startswith("_")]
    names += ["own", "opponents"] if isinstance(message, View) else []
    return {name: _bits(getattr(message, name)) for name in names}


def _decoded(encoding):
    codec = codec_of(encoding)
    data = subprocess.run([_SAMPLES, "write", encoding], check=True, stdout=subprocess.PIPE).stdout
    stream = io.BytesIO(data)
    messages = []
    while piece := codec.read(stream):
        messages.append(codec.decode(piece))
    return messages


def _random_output(draw, frame):
    commands = {
        robot: Command(
            draw.uniform(-3, 3), -0.0, draw.gauss(0, 10), draw.uniform(0, 8), draw.random() < 0.5, draw.random() < 0.5
        )
        for robot in draw.sample(range(16), draw.randrange(17))
    }
    return Output(
        frame * 1000003,
        commands,
        draw.randrange(-1, 16),
        draw.choice([None, *range(16)]),
        draw.random() < 0.5,
        draw.choice(["", f"number-{frame}", "x" * 1000]),
    )


def _described(output):
    cells = [
        str(output.frame),
        str(output.keeper),
        str(-1 if output.leaves is None else output.leaves),
        str(int(output.timeout)),
        output.text,
    ]
    for robot in range(16):
        command = output.commands.get(robot, Command())
        cells += [
            value.hex() for value in (command.vx_mps, command.vy_mps, command.angular_velocity_radps, command.kick_mps)
        ]
        cells += [str(int(command.chip)), str(int(command.dribble))]
    return cells


@unittest.skipUnless(_SAMPLES, "TEAM_SAMPLES is not set")
class SamplesOfTheProgram(unittest.TestCase):
    """Messages of the C++ code."""

    maxDiff = 2000

    def test_are_decoded_to_the_same_bits_in_every_encoding(self):
        flat, *others = [_decoded(encoding) for encoding in _ENCODINGS]
        self.assertEqual([type(message) for message in flat], [Start] + [View] * 200 + [End])
        for messages in others:
            self.assertEqual([*map(_members, messages)], [*map(_members, flat)])

    def test_have_views_of_both_kinds(self):
        views = _decoded("flat")[1:-1]
        self.assertTrue(any(view.ball is None for view in views))
        self.assertTrue(any(robot.vx_mps for view in views for robot in view.own))
        self.assertEqual({view.play for view in views}, set(Play))

    def test_answers_are_read_as_they_were_written(self):
        draw = random.Random(5)
        outputs = [_random_output(draw, frame) for frame in range(100)]
        for encoding in _ENCODINGS:
            data = b"".join(map(codec_of(encoding).encode, outputs))
            read = subprocess.run(
                [_SAMPLES, "read", encoding], check=True, input=data, stdout=subprocess.PIPE
            ).stdout.decode()
            lines = [
                [float.fromhex(cell).hex() if "0x" in cell else cell for cell in line.split(" ")]
                for line in read.splitlines()
            ]
            self.assertEqual(lines, [*map(_described, outputs)], encoding)


class Encodings(unittest.TestCase):
    """Without other programs."""

    def test_end_with_the_stream(self):
        for encoding in _ENCODINGS:
            self.assertEqual(codec_of(encoding).read(io.BytesIO(b"")), b"")

    def test_unknown_one_is_refused_with_the_known_ones(self):
        with self.assertRaisesRegex(ValueError, "unknown encoding 'protobuf'; there are flat, json$"):
            codec_of("protobuf")


if __name__ == "__main__":
    unittest.main()
