"""Many environments, stepped in parallel by several processes."""
from __future__ import annotations

import multiprocessing
import traceback
from multiprocessing.connection import Connection
from multiprocessing.sharedctypes import RawArray
from typing import Any

import numpy as np

from .environments import GymnasiumEnv

_LONGEST_STEP_S = 600.0
_RESET, _STEP = "reset", "step"


class _Shared:
    """Arrays in memory that forked processes share."""

    def __init__(self, environments: int, observation: tuple[int, ...], action: tuple[int, ...]) -> None:
        shapes = [
            (environments, *observation),
            (environments, *action),
            (environments,),
            (environments,),
            (environments,),
        ]
        sizes = [int(np.prod(shape)) for shape in shapes]
        numbers = np.frombuffer(RawArray("d", sum(sizes)))
        parts = np.split(numbers, np.cumsum(sizes)[:-1])
        arrays = [part.reshape(shape) for part, shape in zip(parts, shapes)]
        self.observations, self.actions, self.rewards, self.terminated, self.truncated = arrays


def _work(pipe: Connection, others: list[Connection], shared: _Shared, mine: range, options: dict[str, Any]) -> None:
    """Steps a worker's environments until the other end of the pipe is closed. `others` are inherited
    ends of pipes, which would keep it open."""
    for other in others:
        other.close()
    envs = [GymnasiumEnv(**options) for _ in mine]
    try:
        while True:
            order, seed = pipe.recv()
            infos: dict[int, Any] = {}
            for k, i in enumerate(mine):
                if order == _RESET:
                    shared.observations[i], _ = envs[k].reset(seed=None if seed is None else seed + i)
                    continue
                observation, reward, over, late, info = envs[k].step(shared.actions[i])
                shared.rewards[i], shared.terminated[i], shared.truncated[i] = reward, over, late
                if over or late:
                    infos[i] = info
                    observation, _ = envs[k].reset()
                shared.observations[i] = observation
            pipe.send(infos)
    except EOFError:
        pass
    except BaseException:  # noqa: B902 - the caller raises it
        pipe.send(traceback.format_exc())


class VectorEnv:
    """`environments` environments (GymnasiumEnv) in `workers` processes, stepped together.

    The arrays that reset() and step() return are overwritten by the next step. An environment whose
    episode has ended begins the next one immediately; its last record is in the infos, by index. Use it
    in a `with` statement, or close() it.
    """

    def __init__(self, environments: int, workers: int = 2, seed: int | None = None, **options: Any) -> None:
        one = GymnasiumEnv(**options)
        self.single_observation_space = one.observation_space
        self.single_action_space = one.action_space
        self.num_envs = environments
        self._shared = _Shared(environments, one.observation_space.shape, one.action_space.shape)
        self._pipes: list[Connection] = []
        self._processes: list[multiprocessing.process.BaseProcess] = []
        context = multiprocessing.get_context("fork")
        bounds = np.linspace(0, environments, min(workers, environments) + 1).astype(int)
        for low, high in zip(bounds[:-1], bounds[1:]):
            parent_end, worker_end = context.Pipe()
            process = context.Process(
                target=_work,
                daemon=True,
                args=(worker_end, [*self._pipes, parent_end], self._shared, range(low, high), options),
            )
            process.start()
            worker_end.close()
            self._pipes.append(parent_end)
            self._processes.append(process)
        self._seed = seed

    def reset(self, *, seed: int | None = None) -> tuple[np.ndarray, dict[int, Any]]:
        """Begins an episode in each environment. Environment i starts from seed + i and then continues with
        its own random numbers; the first reset takes the seed of the constructor unless you pass one.
        Without any seed, every reset begins different games."""
        seed, self._seed = self._seed if seed is None else seed, None
        return self._shared.observations, self._all((_RESET, seed))

    def step(self, actions: Any) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, dict[int, Any]]:
        """Returns observations, rewards, terminated and truncated (1 or 0), and infos by index."""
        shared = self._shared
        shared.actions[:] = actions
        infos = self._all((_STEP, None))
        return shared.observations, shared.rewards, shared.terminated, shared.truncated, infos

    def close(self) -> None:
        """Stops the processes."""
        for pipe in self._pipes:
            pipe.close()
        for process in self._processes:
            process.join(5)
            if process.is_alive():
                process.kill()
                process.join()
        self._pipes, self._processes = [], []

    def __enter__(self) -> "VectorEnv":
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()

    def _all(self, order: tuple[str, int | None]) -> dict[int, Any]:
        for pipe in self._pipes:
            pipe.send(order)
        infos: dict[int, Any] = {}
        for pipe in self._pipes:
            if not pipe.poll(_LONGEST_STEP_S):
                raise TimeoutError(f"a worker has not answered for {_LONGEST_STEP_S:g} s")
            answer = pipe.recv()
            if isinstance(answer, str):
                raise RuntimeError("a worker failed:\n" + answer)
            infos.update(answer)
        return infos
