"""TCP 10009: the game controller in CI mode, fed by a simulator."""
import asyncio

from protocol import controller, framed, read_framed

REPEATS = 0.01  # share of outputs that are sent twice


class CiServer:
    """Answers each input with an output for the tick and one for each change."""

    def __init__(self, engine, match, journal):
        self.engine, self.match, self.journal = engine, match, journal
        self.writer = None
        match.on_change = engine.after_tick = self.send

    async def open(self, host, port):
        self.server = await asyncio.start_server(self._serve, host, port)

    async def _serve(self, reader, writer):
        self.journal.note("ci_connected")
        self.writer = writer
        try:
            while True:
                await self._take(await read_framed(reader, controller.CiInput()))
                await writer.drain()
        except (asyncio.IncompleteReadError, ConnectionError):
            pass
        self.writer = None
        self.journal.note("ci_disconnected", time_s=self.match.now)
        writer.close()

    async def _take(self, request):
        if request.HasField("geometry"):
            self.match.field.take(request.geometry.field)
        for entry in request.api_inputs:
            self._do(entry)
        packet = request.tracker_packet
        frame = packet.tracked_frame if packet.HasField("tracked_frame") else None
        await self.engine.add_tick(request.timestamp / 1e9, frame)

    def _do(self, entry):
        if entry.reset_match:
            self.match.reset()
        if entry.HasField("config_delta") and entry.config_delta.HasField("auto_continue"):
            self.match.auto_continue = entry.config_delta.auto_continue
            self.journal.note("config", auto_continue=self.match.auto_continue)
        if entry.HasField("change"):
            self.match.configure(entry.change)
        if entry.HasField("continue_action"):
            action = entry.continue_action
            self.engine.add_action(controller.ContinueAction.Type.Name(action.type), action.for_team)

    def send(self):
        if self.writer is None:
            return
        output = controller.CiOutput()
        output.referee_msg.CopyFrom(self.match.message())
        data = framed(output)
        generator = self.engine.random
        self.writer.write(2 * data if generator is not None and generator.random() < REPEATS else data)
