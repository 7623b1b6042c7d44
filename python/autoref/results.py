"""Reads the files that games and experiments write: tables, event files and logs."""
from __future__ import annotations

import csv
import gzip
import json
import os
import stat
import struct
from collections.abc import Iterator
from pathlib import Path
from typing import Any, BinaryIO, NamedTuple, Union, cast

PathLike = Union[str, "os.PathLike[str]"]
Cell = Union[int, float, str, None]

_LOG_HEADER = struct.Struct(">12si")
_LOG_RECORD = struct.Struct(">qii")
_LOG_SIGNATURE = b"SSL_LOG_FILE"
_LOG_INDEX = 6
_TEXTS = {
    "game_id",
    "team_a",
    "team_b",
    "side_a",
    "rule_changes",
    "end_reason",
    "status",
    "void_reason",
    "transitions",
    "state_hash",
    "config_hash",
    "build",
    "host",
    "cpu",
    "row_crc",
    "shard",
}


class LogMessage(NamedTuple):
    """One message of an SSL log."""

    time_ns: int  # when it was received, in nanoseconds since 1970
    kind: int  # 2: vision of 2010, 3: referee, 4: vision of 2014, 5: tracker
    data: bytes  # the message in protobuf


def _converted(texts: list[str]) -> list[Cell]:
    """Converts a column to whole numbers, or else to floats, or else to texts. Empty numbers become None."""
    for kind in (int, float):
        try:
            return [kind(text) if text else None for text in texts]
        except ValueError:
            continue
    return list(texts)


def _regular_file(name: str, flags: int) -> int:
    """Opens a file of results; never blocks on a FIFO of the same name."""
    descriptor = os.open(name, flags | os.O_NONBLOCK)
    if stat.S_ISREG(os.fstat(descriptor).st_mode):
        return descriptor
    os.close(descriptor)
    raise ValueError(f"{name}: is not a regular file; remove it")


def _columns(file: Path) -> dict[str, list[Cell]]:
    with open(file, newline="", encoding="utf-8", opener=_regular_file) as stream:
        header, *lines = csv.reader(stream)
    columns = zip(*lines) if lines else ([] for _ in header)
    return {name: list(cells) if name in _TEXTS else _converted(list(cells)) for name, cells in zip(header, columns)}


def rows(folder: PathLike, table: str = "results.csv") -> list[dict[str, Cell]]:
    """The rows of a table as dictionaries; needs only the standard library.

    Numbers are int or float, with infinity for inf; an empty cell in a column of numbers is None.
    docs/schemas.md lists the columns. Raises ValueError if a FIFO or a device has the table's name.
    """
    columns = _columns(Path(folder, table))
    return [dict(zip(columns, cells)) for cells in zip(*columns.values())]


def _as_array(columns: dict[str, list[Cell]]) -> Any:
    import numpy  # the other functions do not need it

    arrays = {}
    for name, cells in columns.items():
        has_gaps = any(cell is None for cell in cells)
        arrays[name] = numpy.array(cells, dtype=float if has_gaps else None)
    table = numpy.empty(len(next(iter(arrays.values()))), dtype=[(name, array.dtype) for name, array in arrays.items()])
    for name, array in arrays.items():
        table[name] = array
    return table


def results(folder: PathLike, table: str = "results.csv", *, pandas: bool = False) -> Any:
    """A table of an experiment: a structured numpy array with a field per column, or a DataFrame.

    folder: the experiment's folder, such as results/runs/first-look.
    table: also "summary.csv", "standings.csv" and so on; docs/schemas.md lists the columns.
    pandas: return a pandas.DataFrame.

    An empty cell in a column of numbers becomes NaN. Raises ImportError without numpy or
    pandas; rows() needs neither.
    """
    columns = _columns(Path(folder, table))
    if not pandas:
        return _as_array(columns)
    from pandas import DataFrame

    return DataFrame(columns)


def _open(file: PathLike) -> BinaryIO:
    with open(file, "rb") as stream:
        is_compressed = stream.read(2) == b"\x1f\x8b"
    return cast(BinaryIO, gzip.open(file, "rb")) if is_compressed else open(file, "rb")


def events(file: PathLike) -> Iterator[dict[str, Any]]:
    """The lines of an event file (--events, --game-events), one dictionary each."""
    with _open(file) as stream:
        for line in stream:
            yield json.loads(line)


def log(file: PathLike) -> Iterator[LogMessage]:
    """The messages of an SSL log, compressed or not, up to its index or end.

    Raises ValueError if the file is not an SSL log or ends within a message.
    """
    with _open(file) as stream:
        header = stream.read(_LOG_HEADER.size)
        if len(header) < _LOG_HEADER.size or _LOG_HEADER.unpack(header) != (_LOG_SIGNATURE, 1):
            raise ValueError(f"{file}: not an SSL log of version 1")
        while header := stream.read(_LOG_RECORD.size):
            if len(header) < _LOG_RECORD.size:
                raise ValueError(f"{file}: ends within a message")
            time_ns, kind, length = _LOG_RECORD.unpack(header)
            if kind == _LOG_INDEX:
                return
            data = stream.read(length)
            if len(data) < length:
                raise ValueError(f"{file}: ends within a message")
            yield LogMessage(time_ns, kind, data)
