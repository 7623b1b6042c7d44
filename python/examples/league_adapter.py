#!/usr/bin/env python3
"""Lets a program that speaks the league's messages by UDP play in AutoRef, in lock-step.

usage: league_adapter.py VISION REFEREE CONTROL COMMAND ...

VISION and REFEREE are the addresses on which the program listens, multicast groups for example, and
CONTROL is the one to which it sends its RobotControl, each HOST:PORT. COMMAND starts the
program; COLOUR in its words is replaced by yellow or blue. Packets are sent on the loopback interface
only.
"""
import io
import select
import socket
import subprocess
import sys

LONGEST_WAIT_S = 8.0


def address(text):
    host, port = text.rsplit(":", 1)
    return host, int(port)


def read_varint(stream):
    value = shift = 0
    while True:
        byte = stream.read(1) or sys.exit()  # AutoRef has closed the pipe
        value |= (byte[0] & 127) << shift
        shift += 7
        if byte[0] < 128:
            return value


def read_message():
    """The packets of the next LeagueInput, as lists by field number."""
    content, fields = sys.stdin.buffer.read(read_varint(sys.stdin.buffer)), {}
    stream = io.BytesIO(content)
    while stream.tell() < len(content):
        key, value = read_varint(stream), read_varint(stream)
        fields.setdefault(key >> 3, []).append(stream.read(value) if key & 7 == 2 else value)
    return fields


def answer_to(message, repeat_s):
    """The program's RobotControl."""
    while select.select([udp], [], [], 0)[0]:  # answers to earlier packets
        udp.recv(65536)
    for _ in range(round(LONGEST_WAIT_S / repeat_s)):
        udp.sendto(message[2][0], referee)
        for packet in message[1]:
            udp.sendto(packet, vision)
        if select.select([udp], [], [], repeat_s)[0]:
            answer, sender = udp.recvfrom(65536)
            udp.sendto(message[3][0], sender)
            return answer
    sys.exit(f"no RobotControl within {LONGEST_WAIT_S:g} s")


vision, referee, control = map(address, sys.argv[1:4])
udp = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
udp.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_IF, socket.inet_aton("127.0.0.1"))
udp.bind(control)
print("autoref-team 1 league", flush=True)
colour = "yellow" if read_message()[4][0] else "blue"
program = subprocess.Popen(
    [word.replace("COLOUR", colour) for word in sys.argv[4:]], stdin=subprocess.DEVNULL, stdout=sys.stderr
)
frame = None
while 5 in (message := read_message()):
    if message[5] != frame:  # the first frame is sent several times, because of the latency
        # Packets are repeated until the program listens.
        answer = answer_to(message, LONGEST_WAIT_S if frame else 0.1)
    frame, length = message[5], len(answer)
    sys.stdout.buffer.write(bytes([length] if length < 128 else [length & 127 | 128, length >> 7]))
    sys.stdout.buffer.write(answer)
    sys.stdout.buffer.flush()
program.terminate()
