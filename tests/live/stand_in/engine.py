"""The order in which the controller works: changes, continue actions and ticks wait in three
queues, of which any may be next."""
import asyncio
import collections
import os
import random

from person import Crash

PAUSES = 0.1  # share of changes and actions before which the engine pauses
LONGEST_PAUSE_S = 0.001


class Engine:
    """Without a seed, each input is done before the next one is read. Otherwise the order is random,
    and a continue action that is taken before the change of an earlier one is fatal."""

    def __init__(self, match, journal, seed=None):
        self.match, self.journal = match, journal
        self.random = None if seed is None else random.Random(seed)
        self.changes, self.actions, self.ticks = (collections.deque() for _ in range(3))
        self.wake, self.taken = asyncio.Event(), asyncio.Event()
        self.pending = ""  # the action whose change has not been made yet
        self.after_tick = lambda: None
        match.enqueue = self.add_change
        match.continue_with = self.add_action

    def add_change(self, change):
        self._add(self.changes, change)

    def add_action(self, name, team):
        self._add(self.actions, (name, team))

    async def add_tick(self, now, frame):
        """Waits as long as the tick before is waiting."""
        while self.ticks:
            self.taken.clear()
            await self.taken.wait()
        self._add(self.ticks, (now, frame))
        if self.random is None:
            self.take_all()

    def _add(self, queue, item):
        queue.append(item)
        self.wake.set()

    async def run(self):
        while True:
            queues = [queue for queue in (self.changes, self.actions, self.ticks) if queue]
            if not queues:
                self.wake.clear()
                await self.wake.wait()
                continue
            if self.random is None:
                self.take_all()
                continue
            queue = self.random.choice(queues)
            if queue is not self.ticks and self.random.random() < PAUSES:
                await asyncio.sleep(self.random.uniform(0, LONGEST_PAUSE_S))
            self.take(queue)

    def take_all(self):
        while self.changes or self.actions or self.ticks:
            self.take(self.changes or self.actions or self.ticks)

    def take(self, queue):
        item = queue.popleft()
        if queue is self.changes:
            item()
        elif queue is self.actions:
            self._perform(*item)
        else:
            self.taken.set()
            self.match.tick(*item)
            self.after_tick()

    def _perform(self, name, team):
        try:
            if self.pending and self.random is not None:
                raise Crash(f"{name} while {self.pending} is pending")
            self.pending = name
            self.match.act(name, team, self._made)
        except Crash as crash:
            self.journal.note("crashed", why=str(crash))
            os._exit(2)

    def _made(self):
        self.pending = ""
