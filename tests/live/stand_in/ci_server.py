"""TCP 10009: the game controller in CI mode, fed by a simulator."""
import asyncio

from protocol import controller, framed, read_framed


class CiServer:
    """Answers each input with one output per change and one for the tick."""

    def __init__(self, match, journal):
        self.match, self.journal = match, journal
        self.writer = None
        match.on_change = self.send

    async def open(self, host, port):
        self.server = await asyncio.start_server(self._serve, host, port)

    async def _serve(self, reader, writer):
        self.journal.note("ci_connected")
        self.writer = writer
        try:
            while True:
                self._take(await read_framed(reader, controller.CiInput()))
                await writer.drain()
        except (asyncio.IncompleteReadError, ConnectionError):
            pass
        self.writer = None
        self.journal.note("ci_disconnected", time_s=self.match.now)
        writer.close()

    def _take(self, request):
        if request.HasField("geometry"):
            self.match.field.take(request.geometry.field)
        for entry in request.api_inputs:
            self._do(entry)
        packet = request.tracker_packet
        frame = packet.tracked_frame if packet.HasField("tracked_frame") else None
        self.match.tick(request.timestamp / 1e9, frame)
        self.send()

    def _do(self, entry):
        if entry.reset_match:
            self.match.reset()
            self.send()
        if entry.HasField("change"):
            self.match.configure(entry.change)
        if entry.HasField("continue_action"):
            action = entry.continue_action
            self.match.act(controller.ContinueAction.Type.Name(action.type), action.for_team)

    def send(self):
        if self.writer is not None:
            output = controller.CiOutput()
            output.referee_msg.CopyFrom(self.match.message())
            self.writer.write(framed(output))
