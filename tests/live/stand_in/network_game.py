"""A game on the network: referee packets out, tracker and vision packets in, and a person who
presses the buttons."""
import asyncio
import socket
import struct
import time

from engine import Engine
from laws import BEFORE_HALVES, HALT, HALVES, POST_GAME, PREPARE_KICKOFF, PREPARE_PENALTY
from protocol import tracker, vision

REFEREE, VISION_GROUP = ("224.5.23.1", 10003), "224.5.23.2"
EVERY_S = 0.025
TRACKER_SILENCE_S = 1  # after which another tracker is followed, as by the real controller


def listening(port, interface):
    receiver = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    receiver.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    receiver.bind((VISION_GROUP, port))
    membership = socket.inet_aton(VISION_GROUP) + socket.inet_aton(interface)
    receiver.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, membership)
    receiver.setblocking(False)
    return receiver


class Person:
    """Presses what the controller waits for, a second after it does."""

    def press(self, match):
        if match.now - match.command_s < 1 or match.stage == POST_GAME:
            return
        if match.stage in HALVES and match.stage_left < 0 and not match.is_play:
            match.act("NEXT_STAGE" if match.stage == 1 else "END_GAME", 0)
        elif match.goal is not None:
            match.act("ACCEPT_GOAL", 0)
        elif match.stage not in HALVES | BEFORE_HALVES:
            match.act("NEXT_STAGE", 0)
        elif match.command == HALT:
            match.act("RESUME_FROM_HALT", 0)
        elif match.command & ~1 in (PREPARE_KICKOFF, PREPARE_PENALTY) and match.is_placed():
            match.act("NORMAL_START", 0)


class NetworkGame:
    def __init__(self, match, journal, interface):
        self.match, self.journal = match, journal
        self.frame, self.source, self.tracked_s = None, None, -TRACKER_SILENCE_S
        self.is_away = False
        self.person = Person()
        self.sender = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.sender.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_IF, socket.inet_aton(interface))
        self.sender.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_TTL, struct.pack("b", 0))
        loop = asyncio.get_running_loop()
        for port, take in ((10010, self._take_tracks), (10006, self._take_vision)):
            receiver = listening(port, interface)
            loop.add_reader(receiver, self._read, receiver, take)
        match.on_change = self.publish
        self.engine = Engine(match, journal)

    def _read(self, receiver, take):
        try:
            take(receiver.recv(65536))
        except Exception as error:  # what cannot be parsed
            self.journal.note("wrong_packet", error=str(error))

    def _take_tracks(self, data):
        packet = tracker.TrackerPacket.FromString(data)
        now = time.monotonic()
        if not packet.HasField("tracked_frame"):
            return
        if packet.uuid != self.source:
            if now - self.tracked_s < TRACKER_SILENCE_S:
                return
            self.source = packet.uuid
            self.journal.note("tracker", source=packet.source_name.decode())
        self.frame, self.tracked_s = packet.tracked_frame, now

    def _take_vision(self, data):
        packet = vision.VisionPacket.FromString(data)
        if packet.HasField("geometry"):
            self.match.field.take(packet.geometry.field)

    def publish(self):
        if not self.is_away:
            self.sender.sendto(self.match.message().SerializeToString(), REFEREE)

    async def run(self):
        while True:
            self.match.tick(time.time(), self.frame)
            if not self.is_away:
                self.person.press(self.match)
            self.engine.take_all()
            if not self.is_away:
                self.publish()
            await asyncio.sleep(EVERY_S)
