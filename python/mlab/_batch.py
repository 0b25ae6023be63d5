"""The same mission many times."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from . import _core
from ._errors import Error, Problem, problems_of
from ._table import Table
from ._values import path_of, positive, whole, written


class Combination(NamedTuple):
    """What the runs with the same values say together."""

    set: dict[str, str]
    """The values in place of what the mission says."""
    runs: int
    """How many there are."""
    successes: int
    """How many of them succeeded."""
    low: float
    """The lower end of the interval of the share of successes."""
    high: float
    """Its upper end."""
    against: bool
    """They are runs of the version that the mission is compared with."""

    @property
    def share(self) -> float:
        """Of successes; NaN without runs."""
        return self.successes / self.runs if self.runs else float("nan")


class Batch(Table):
    """A row for each run, by combination and seed; the columns are those of ``mlab batch --table`` (``docs/batch.md``).

    Numbers are arrays of float64 (whole ones int64), with NaN where there was nothing to measure; words are
    arrays of text; ``success`` is of truths.
    """

    def __init__(self, columns: Mapping[str, np.ndarray], said: dict, warnings: tuple[Problem, ...]) -> None:
        """Made by :func:`mlab.batch`."""
        super().__init__(columns)
        self._said = said
        self._warnings = warnings

    @property
    def summary(self) -> dict:
        """What the runs say together, as in ``mlab batch --table FILE.json``: intervals, distributions, failures by
        cause, requirements, comparisons in pairs."""
        return self._said["summary"]

    @property
    def combinations(self) -> list[Combination]:
        """Each combination of values, with its share of successes and an interval for it."""
        all_of_them = self.summary["combinations"]
        # Those of the mission come first, as many of the version that it is compared with behind them.
        own = len(all_of_them) // 2 if "against" in self._said else len(all_of_them)
        return [
            Combination(one["set"], one["runs"], one["successes"], one["low"], one["high"], place >= own)
            for place, one in enumerate(all_of_them)
        ]

    @property
    def requirements_met(self) -> bool:
        """All that ``require`` asked for is so; true where it asked for nothing."""
        return all(one["met"] for one in self.summary["requirements"])

    @property
    def warnings(self) -> tuple[Problem, ...]:
        """What is odd in the mission."""
        return self._warnings


def batch(
    mission: str | os.PathLike,
    runs: int | None = None,
    *,
    seed: int | None = None,
    set: Mapping[str, object] | None = None,
    combine: str | None = None,
    draw: str | None = None,
    success: str | None = None,
    require: str | Sequence[str] = (),
    until: str | None = None,
    confidence: float | None = None,
    against: str | os.PathLike | None = None,
    start_time: str | None = None,
    patience: float | None = None,
    duration: float | None = None,
    limit: float | None = None,
    environment: str | os.PathLike | None = None,
    threads: int | None = None,
    allow_native: bool = False,
    cell: bool = True,
    progress: Callable[[int, int], object] | None = None,
    page: str | os.PathLike | None = None,
) -> Batch:
    """Carries a mission out many times, on all processors, as ``mlab batch`` does (see ``docs/batch.md``).

    mission: an ``.mdl`` file, or a definition of a batch, a ``.toml`` file; what is given here counts more than
        what stands there. Files that a definition wants written are not.
    runs: of each combination of values; 100 where nothing says how many.
    seed: of the first run of each combination; the others follow.
    set: values in place of what the mission says. A list is one combination after the other, a text is as
        ``--set`` takes it: ``{"base_velocity": [1, 2, 5], "robot_radius": "0.1..0.3"}``.
    combine: ``crossed``: each value with each; ``paired``: the first of all lists together, then the second.
    draw: ``random``, or ``latin`` for a Latin hypercube.
    success: when a run is a success: ``outcome == done and contacts == 0``.
    require: what the share of successes has to be: ``success >= 0.95 @ 0.99``; see :attr:`Batch.requirements_met`.
    until: stops early: ``decided``, or ``success +- 0.05 @ 0.95``.
    confidence: of the intervals.
    against: another version of the mission, with which it is compared in pairs.
    start_time: what the mission's clock shows at the start of each run: ``YYYY-MM-DD HH:MM[:SS]``.
    patience: simulated seconds without progress after which a command has failed.
    duration: each run goes on for so many simulated seconds, and is done.
    limit: each run ends after so many simulated seconds, as interrupted.
    environment: a file that says what changes in the world.
    threads: how many runs at once; None: one for each processor. The result is the same.
    allow_native, cell: as for :func:`load`.
    progress: called several times a second with how many runs are done, and how many there are at most.
    page: a file for the page with plots that ``mlab batch --html`` writes: ``FILE.html``.

    The result does not depend on the number of threads. Ctrl-C, and what ``progress`` raises, ends it.
    """
    given = [
        (field, str(value))
        for field, value in (
            ("runs", None if runs is None else whole(runs, "runs")),
            ("seed", None if seed is None else whole(seed, "seed")),
            ("combine", combine),
            ("draw", draw),
            ("success", success),
            ("until", until),
            ("confidence", None if confidence is None else positive(confidence, "confidence")),
            ("against", None if against is None else path_of(against, "against")),
            ("start-time", start_time),
            ("patience", None if patience is None else positive(patience, "patience")),
            ("for", None if duration is None else positive(duration, "duration")),
            ("limit", None if limit is None else positive(limit, "limit")),
            ("environment", None if environment is None else path_of(environment, "environment")),
        )
        if value is not None
    ]
    if set is not None and not isinstance(set, Mapping):
        raise TypeError(f"set: expected names with their values, {{'base_velocity': [1, 2]}}, not {type(set).__name__}")
    given += [("set", f"{name}={_values(value, str(name))}") for name, value in (set or {}).items()]
    given += [("require", one) for one in _texts(require, "require")]
    if page is not None:
        _try_to_write_page(path_of(page, "page"))
    if progress is not None and not callable(progress):
        raise TypeError("progress: expected something that can be called with two numbers")
    processors = len(os.sched_getaffinity(0))
    made = _core.batch(
        path_of(mission, "mission"),
        given,
        processors if threads is None else whole(threads, "threads", 1, 256),
        bool(allow_native),
        bool(cell),
        page is not None,
        progress,
    )
    if page is not None:
        with open(path_of(page, "page"), "w", encoding="utf-8") as out:
            out.write(made["page"])
    said = json.loads(made["json"])
    rows = said.pop("runs")
    return Batch(_columns(rows), said, problems_of(made["warnings"]))


def _texts(value: object, what: str) -> list[str]:
    texts = [value] if isinstance(value, str) else list(value) if isinstance(value, Iterable) else [value]
    if not all(isinstance(one, str) for one in texts):
        raise TypeError(f"{what}: expected a text, or a list of texts, not {type(value).__name__}")
    return texts


def _try_to_write_page(file: str) -> None:
    """Before the runs, which may take hours. What stands in the file is left alone."""
    if os.path.splitext(file)[1] not in (".html", ".htm"):
        raise Error(f"page {file}: expected FILE.html")
    is_there = os.path.lexists(file)
    try:
        with open(file, "a", encoding="utf-8"):
            pass
    except OSError as problem:
        raise Error(f"page {file}: the file can't be written: {problem.strerror}") from None
    if not is_there:
        os.remove(file)


def _values(value: object, what: str) -> str:
    if isinstance(value, (str, bytes)):
        return written(value, what)
    if isinstance(value, (list, tuple, range, np.ndarray)):
        return ",".join(written(one, what) for one in value)
    return written(value, what)


_WORDS = ("mission", "outcome", "cause", "message", "repeat")


def _columns(rows: list[dict]) -> dict[str, np.ndarray]:
    return {name: _column(name, [row[name] for row in rows]) for name in (rows[0] if rows else ())}


def _column(name: str, values: list) -> np.ndarray:
    if name in _WORDS:
        return np.array(["" if value is None else value for value in values])
    if all(isinstance(value, str) for value in values):  # what was set, as it was written
        try:
            return np.array([float(value) for value in values])
        except ValueError:
            return np.array(values)
    if all(type(value) in (int, float, type(None)) for value in values) and not all(type(value) is int for value in values):
        return np.array([np.nan if value is None else value for value in values], dtype=np.float64)
    return np.array(values)
