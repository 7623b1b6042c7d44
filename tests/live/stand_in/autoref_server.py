"""TCP 10007: automatic referees register and report events."""
import asyncio
import secrets

import events
from protocol import controller, framed, read_framed

OK, REJECTED, UNVERIFIED = 1, 2, 2


class Faults:
    """What goes wrong from the `after`-th message of a registered referee on."""

    def __init__(self, kind="", after=0):
        self.kind, self.after = kind, after  # '', 'reject', 'silent', 'cut'

    def of_message(self, number):
        return self.kind if number >= self.after else ""


class AutorefServer:
    def __init__(self, match, journal, faults):
        self.match, self.journal, self.faults = match, journal, faults
        self.names = set()
        self.connections = set()
        self.registered = asyncio.Event()  # the first
        self.server = None

    async def open(self, host, port):
        self.server = await asyncio.start_server(self._serve, host, port)

    async def close(self):
        self.server.close()
        for writer in list(self.connections):
            writer.transport.abort()
        await self.server.wait_closed()

    async def _serve(self, reader, writer):
        self.connections.add(writer)
        name = ""
        try:
            name = await self._register(reader, writer)
            if name:
                await self._listen(reader, writer, name)
        except (asyncio.IncompleteReadError, ConnectionError):
            pass
        except Exception as error:  # what cannot be parsed
            self.journal.note("wrong_message", autoref=name, error=str(error))
        self.names.discard(name)
        self.match.autorefs = len(self.names)
        self.connections.discard(writer)
        self.journal.note("disconnected", autoref=name)
        writer.close()

    async def _register(self, reader, writer):
        """The name under which the referee is registered, or '' after a rejection."""
        self._reply(writer, OK)
        request = await read_framed(reader, controller.AutoRefRegistration())
        name = request.identifier.decode()
        if not name or name in self.names:
            self.journal.note("registration_rejected", autoref=name)
            self._reply(writer, REJECTED, "the name is empty or taken")
            await writer.drain()
            return ""
        self.names.add(name)
        self.match.autorefs = len(self.names)
        self.journal.note("registered", autoref=name)
        self.registered.set()
        self._reply(writer, OK)
        return name

    async def _listen(self, reader, writer, name):
        number = 0
        while True:
            message = await read_framed(reader, controller.AutoRefToController())
            number += 1
            fault = self.faults.of_message(number)
            self._note(name, message, fault)
            if fault == "silent":
                continue
            if fault == "cut":
                self._cut(writer)
                return
            if fault == "reject":
                self._reply(writer, REJECTED, "scripted")
                continue
            self._take(name, message, writer)

    def _note(self, name, message, fault):
        event = message.game_event if message.HasField("game_event") else None
        kind = "keep_alive" if event is None else "received"
        values = (
            {}
            if event is None
            else {
                "event": events.NAMES.get(event.type, str(event.type)),
                "field": event.WhichOneof("event"),
                "text": str(event),
            }
        )
        self.journal.note(kind, autoref=name, fault=fault, **values)

    def _take(self, name, message, writer):
        if not message.HasField("game_event"):
            self._reply(writer, OK)
            return
        event = message.game_event
        if not event.HasField("type") or event.WhichOneof("event") is None:
            self._reply(writer, REJECTED, "the event has no type")
            return
        del event.origin[:]
        event.origin.append(name.encode())
        self.match.propose(event, name)
        self._reply(writer, OK)

    @staticmethod
    def _reply(writer, status, reason=""):
        message = controller.ControllerToAutoRef()
        reply = message.controller_reply
        reply.status_code, reply.verification = status, UNVERIFIED
        reply.next_token = secrets.token_hex(8).encode()
        if reason:
            reply.reason = reason.encode()
        writer.write(framed(message))

    @staticmethod
    def _cut(writer):
        """Closes the connection in the middle of a message."""
        writer.write(b"\x20\x0a")
