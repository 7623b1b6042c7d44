"""Sockets of a program that listens to the league's groups on the loopback."""
import os
import socket

HOST = "127.0.0.1"
VISION = "224.5.23.2", 10006
REFEREE = "224.5.23.1", 10003
TRACKER = "224.5.23.2", 10010
LARGEST_DATAGRAM = 65536
BUFFER_BYTES = 1 << 22
SO_RCVBUFFORCE = 33  # Linux; not in Python's module


def listening(group, port):
    """A socket that receives a group's packets and never blocks."""
    udp = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    udp.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    enlarge_buffer(udp)
    udp.bind((group, port))
    membership = socket.inet_aton(group) + socket.inet_aton(HOST)
    udp.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, membership)
    udp.setblocking(False)
    return udp


def enlarge_buffer(udp):
    """Beyond the system's limit if that is allowed."""
    try:
        udp.setsockopt(socket.SOL_SOCKET, SO_RCVBUFFORCE, BUFFER_BYTES)
    except OSError:
        udp.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, BUFFER_BYTES)


def lost_packets(udp):
    """Packets for which there was no room in the socket's buffer, as Linux counts them."""
    inode = str(os.fstat(udp.fileno()).st_ino)
    with open("/proc/net/udp", encoding="ascii") as table:
        rows = [line.split() for line in table][1:]
    return next(int(row[-1]) for row in rows if row[9] == inode)


def sending(port=0):
    """A socket that sends from `port`, or from any, and never blocks."""
    udp = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    udp.bind((HOST, port))
    udp.setblocking(False)
    return udp


def waiting(udp):
    """Each datagram that waits in a socket."""
    while True:
        try:
            yield udp.recv(LARGEST_DATAGRAM)
        except BlockingIOError:
            return
        except ConnectionRefusedError:
            continue  # nobody listens at the port we sent to
