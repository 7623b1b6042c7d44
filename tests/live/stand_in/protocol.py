"""The league's messages, compiled from the project's definitions, and their framing on TCP."""
import glob
import importlib
import os
import subprocess
import sys
import tempfile

_FOLDER = os.path.join(os.path.dirname(__file__), "../../../league")


def _compile():
    target = tempfile.TemporaryDirectory()
    files = sorted(glob.glob("messages/*.proto", root_dir=_FOLDER))
    subprocess.run(["protoc", "--python_out", target.name, "-I", "."] + files, check=True, cwd=_FOLDER)
    sys.path.insert(0, target.name)
    modules = [
        importlib.import_module(f"messages.{name}_pb2")
        for name in ("game_controller", "game_event", "referee", "simulation", "tracker", "vision")
    ]
    target.cleanup()
    return modules


controller, game_event, referee, simulation, tracker, vision = _compile()

LONGEST_MESSAGE = 1 << 20

YELLOW, BLUE = 1, 2


def framed(message):
    data = message.SerializeToString()
    size = len(data)
    head = bytearray()
    while size > 127:
        head.append(size & 127 | 128)
        size >>= 7
    head.append(size)
    return bytes(head) + data


async def read_framed(reader, message):
    """Reads one message from an asyncio stream."""
    size = shift = 0
    while True:
        byte = (await reader.readexactly(1))[0]
        size |= (byte & 127) << shift
        shift += 7
        if byte < 128:
            break
        if shift > 28:
            raise ValueError("a length of more than 4 bytes")
    if size > LONGEST_MESSAGE:
        raise ValueError(f"a message of {size} bytes")
    message.ParseFromString(await reader.readexactly(size))
    return message


def opponent_of(team):
    return {YELLOW: BLUE, BLUE: YELLOW}.get(team, 0)


def name_of_team(team):
    return {YELLOW: "YELLOW", BLUE: "BLUE"}.get(team, "UNKNOWN")
