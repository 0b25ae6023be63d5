"""Missions, runs and robots."""

from __future__ import annotations

import json
import os
import warnings
from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from . import _core
from ._errors import Error, MissionWarning, Problem, problems_of
from ._table import Table
from ._values import NotPickled, names_of, path_of, positive, text_of, whole, written

_MOST_CYCLES = 2**63 - 1


class Port(NamedTuple):
    """A value of a robot's program that has a name, as ``mlab describe`` shows it."""

    path: str
    """Its name: a parameter, ``node.input`` of a constant, ``node`` of an output."""
    role: str
    """``parameter`` and ``constant`` can be set, an ``output`` held."""
    type: str
    """As CNL and CDL call it: ``double``, ``Vector``, ..."""
    unit: str
    """Of what you read. Angles are in radians; empty: none."""
    written_in: str
    """The unit in which :meth:`Run.set` and :meth:`Run.hold` take it: ``deg`` where its author says so."""
    help: str
    """What it is for."""
    low: float | None
    """The least that may be set, in ``written_in``; None: no limit, or no number."""
    high: float | None
    """The most that may be set."""


def _ports(described: list[dict]) -> dict[str, Port]:
    return {one["path"]: Port(**one) for one in described}


class Robot(NotPickled):
    """A robot of a run, as it stands now. What it tells are copies: nothing in them changes when the run goes on."""

    _why = "it is part of a run"

    def __init__(self, run: Run, number: int) -> None:
        """Made by :attr:`Run.robots`."""
        self._run = run
        self._number = number

    @property
    def number(self) -> int:
        """As missions count robots, from 1."""
        return self._number

    def _now(self) -> dict:
        return self._run._core.robot(self._number)

    @property
    def type(self) -> str:
        """The name of its robot type in the mission, such as ``ROBOT``."""
        return self._now()["type"]

    @property
    def life(self) -> str:
        """``not started``, ``running``, ``parked``, ``stopped`` or ``faulted``, as the report calls it."""
        return self._now()["life"]

    @property
    def fault(self) -> str:
        """Why it stands, as a sentence; empty: it has no fault."""
        return self._now()["fault"]

    @property
    def pose(self) -> np.ndarray:
        """``[x, y, heading]`` in the world: metres east and north, radians counter-clockwise from east.

        NaN as long as it has not started.
        """
        return self._now()["pose"]

    @property
    def velocity(self) -> np.ndarray:
        """``[x, y]`` in the world, as driven in the last cycle [m/s]."""
        return self._now()["velocity"]

    @property
    def distance(self) -> float:
        """Driven since it was there [m]."""
        return self._now()["distance"]

    @property
    def contacts(self) -> int:
        """How often it met something solid, or another robot."""
        return self._now()["contacts"]

    @property
    def in_contact(self) -> bool:
        """Whether it touches something now, or did a moment ago."""
        return self._now()["in_contact"]

    @property
    def carries(self) -> int:
        """The number of the object that it carries; 0: none."""
        return self._now()["carries"]

    @property
    def ports(self) -> dict[str, Port]:
        """All ports of its program, by name."""
        return _ports(self._run._core.describe(self._number))

    def port(self, name: str) -> object:
        """What one port holds, as :meth:`Run.port`."""
        return self._run.port(self._number, name)

    def explain(self) -> str:
        """What holds the robot where it is: what pulls and pushes it, and what is near."""
        return "\n".join(self._run._core.explain(self._number))

    def __repr__(self) -> str:
        """Who it is, and where."""
        now = self._now()
        x, y, heading = now["pose"]
        return f"<robot {self._number} ({now['type']}, {now['life']}) at {x:.2f}, {y:.2f}, {heading:.2f} rad>"


class Checkpoint(NotPickled):
    """A run as it stood between two cycles: :meth:`Run.save` makes one, :meth:`Run.restore` goes on from it."""

    _why = "it shares programs with runs of this process"

    def __init__(self, core: object, mission: Mission, seed: int) -> None:
        """Made by :meth:`Run.save`."""
        self._core = core
        self._mission = mission
        self._seed = seed

    @property
    def time(self) -> float:
        """Simulated [s]."""
        return self._core.time

    @property
    def cycle(self) -> int:
        """How many cycles had run."""
        return self._core.cycle

    def __repr__(self) -> str:
        """When it was made."""
        return f"<checkpoint at {self.time:.1f} s (cycle {self.cycle})>"


class Run(NotPickled):
    """A mission that is carried out, cycle by cycle. :meth:`Mission.run` makes one.

    The same mission and seed give the same run, bit for bit, for any number of threads. Everything that is read
    is a copy. A run serves one thread at a time, and only the process that made it; other threads of Python go
    on while it computes, and Ctrl-C ends :meth:`step`, :meth:`finish` and :meth:`trace` between two cycles.
    """

    _why = "it is computed in this process; pickle what you read of it, or make it again from mission and seed"

    def __init__(self, core: object, mission: Mission) -> None:
        """Made by :meth:`Mission.run`."""
        self._core = core
        self._mission = mission
        self._robots = {}

    # ---- time

    def step(self, cycles: int = 1) -> int:
        """Goes on for so many control cycles.

        Returns how many went by: fewer, down to 0, where the mission ends (:attr:`is_over`) or waits for an
        answer (:attr:`questions`).
        """
        return self._core.step(whole(cycles, "cycles", 0, _MOST_CYCLES))

    def finish(self, limit: float | None = None) -> str:
        """Goes on until the mission is over or waits for somebody, or for ``limit`` more simulated seconds.

        Returns the outcome, as :attr:`outcome`.
        """
        cycles = _MOST_CYCLES if limit is None else self._cycles(limit, "limit")
        self.step(cycles)
        return self.outcome

    def trace(
        self,
        ports: str | Sequence[str] = (),
        *,
        seconds: float | None = None,
        robots: int | Sequence[int] = (),
        every: int = 1,
    ) -> Table:
        """Goes on as :meth:`finish` does, and notes numbers after each cycle.

        ports: names of ports, in which ``*`` stands for any characters. A vector gives columns ``PORT.x``,
            ``PORT.y``, ``PORT.z``, a pose ``PORT.x``, ``PORT.y``, ``PORT.heading``; truths and choices are
            numbers. Words are left out.
        seconds: for so long, in simulated time; None: to the end.
        robots: numbers of robots; none: all of the mission.
        every: only each so many-th cycle is noted.

        Returns a table with a row for each robot in each cycle: ``cycle``, ``time`` [s], ``robot``, ``x``, ``y``
        [m], ``heading`` [rad], and a column for each number. Where a robot has no such port stands NaN.
        """
        cycles = _MOST_CYCLES if seconds is None else self._cycles(seconds, "seconds")
        numbers = [robots] if isinstance(robots, int) else list(robots)
        names, rows = self._core.trace(
            cycles,
            names_of(ports, "ports"),
            [whole(one, "robots", 0, 2**32 - 1) for one in numbers],
            whole(every, "every", 1),
        )
        out = {name: rows[:, i].copy() for i, name in enumerate(names)}
        for name in ("cycle", "robot"):
            out[name] = out[name].astype(np.int64)
        return Table(out)

    def _cycles(self, seconds: float, what: str) -> int:
        return min(max(1, round(positive(seconds, what) / self.cycle_duration)), _MOST_CYCLES)

    @property
    def time(self) -> float:
        """Simulated time since the start [s]."""
        return self._core.time()

    @property
    def cycle(self) -> int:
        """How many control cycles have run."""
        return self._core.cycle()

    @property
    def cycle_duration(self) -> float:
        """How long one is [s]."""
        return self._core.cycle_duration()

    @property
    def seed(self) -> int:
        """That all its chances come from."""
        return self._core.seed()

    @property
    def mission(self) -> Mission:
        """What is carried out."""
        return self._mission

    # ---- how it stands

    @property
    def is_over(self) -> bool:
        """The mission has ended: :meth:`step` does nothing any more."""
        return self._core.is_over()

    @property
    def is_waiting(self) -> bool:
        """The last step found that only an answer moves the mission on."""
        return self._core.is_waiting()

    @property
    def outcome(self) -> str:
        """As the report says it: ``done``, ``failed``, ``aborted``; ``running`` or ``waiting`` where it is not over."""
        if self.is_over:
            return self._core.outcome()
        return "waiting" if self.is_waiting else "running"

    @property
    def steps_done(self) -> int:
        """How many steps of the mission are done."""
        return self._core.steps_done()

    @property
    def robots(self) -> tuple[Robot, ...]:
        """All robots of the mission in the order of their numbers, started or not."""
        return tuple(self._robots.setdefault(one, Robot(self, one)) for one in self._core.robots())

    @property
    def poses(self) -> np.ndarray:
        """Where all robots are: an array of the shape (robots, 3), a row ``[x, y, heading]`` for each.

        Units and frame as of :attr:`Robot.pose`; rows in the order of :attr:`robots`.
        """
        return self._core.poses()

    @property
    def messages(self) -> list[tuple[float, str, str]]:
        """What was told: time [s], kind (``message``, ``warning``, ``step ended``, ...), text. The last 10,000."""
        return self._core.said()

    def report(self) -> dict:
        """How the run went, as ``mlab run --report`` writes it (see ``docs/report.md``)."""
        return json.loads(self._core.report())

    # ---- what programs compute

    def port(self, robot: int | Robot, name: str) -> object:
        """What a port of a robot's program holds after the last cycle.

        robot: its number, or a :class:`Robot`.
        name: of the port. With a ``*``, which stands for any characters, a dictionary of all that match.

        A number, truth or text is what it is in Python; a vector, point or pose an array ``[x, y, z]``,
        ``[x, y]``, ``[x, y, heading]``. SI units, angles in radians; vectors are in the robot's frame (x ahead,
        y left), points and poses in the world. Lists and choices are text.
        """
        found = self._core.ports(_number(robot), _port(name, "name"))
        return found if "*" in name else found[name]

    def set(self, robot: int | Robot, port: str, value: object) -> None:
        """Sets a parameter or constant of a robot's program, from the next cycle on.

        value: a number in the unit that :attr:`Port.written_in` names, a truth, a few numbers for a vector or
            point, or text as missions write it; a point may be the name of a place.
        """
        name = _port(port)
        self._core.set(_number(robot), name, written(value, name))

    def hold(self, robot: int | Robot, port: str, value: object) -> None:
        """Holds an output of the robot's program at a value, whatever it computes, until it is released.

        value: as for :meth:`set`.
        """
        name = _port(port)
        self._core.hold(_number(robot), name, written(value, name))

    def release(self, robot: int | Robot, port: str | None = None) -> None:
        """Lets go of what :meth:`hold` holds; None: of all."""
        self._core.release(_number(robot), "" if port is None else _port(port))

    def force(self, robot: int | Robot, sequence: str, state: str) -> None:
        """In the next cycle a sequence of the robot's program goes to a state, whatever its triggers say."""
        self._core.force(
            _number(robot),
            text_of(sequence, "sequence", "the name of a sequence"),
            text_of(state, "state", "the name of a state"),
        )

    # ---- what an operator does

    @property
    def questions(self) -> dict[int, str]:
        """What the mission asks its operator, by number; there are none unless it runs with ``proceed=False``."""
        return self._core.questions()

    def answer(self, question: int, proceed: bool = True) -> None:
        """Answers a question of :attr:`questions`; without ``proceed`` the mission is aborted."""
        self._core.answer(whole(question, "question", 0, 2**32 - 1), bool(proceed))

    def order(self, line: str) -> None:
        """An order as an operator types it: ``run.order("UNIT scouts MOVETO Gate")``."""
        self._core.order(text_of(line, "line", "an order"))

    def abort(self) -> None:
        """Ends the mission."""
        self._core.abort()

    # ---- back and forth

    def save(self) -> Checkpoint:
        """How the run stands now. Takes some microseconds, and memory for what robots and bodies hold."""
        return Checkpoint(self._core.save(), self._mission, self.seed)

    def restore(self, checkpoint: Checkpoint) -> None:
        """Goes on from a checkpoint of this run, or of another one of the same mission and seed, bit for bit."""
        if not isinstance(checkpoint, Checkpoint):
            raise TypeError(f"checkpoint: expected what save() gave, not {type(checkpoint).__name__}")
        if checkpoint._mission is not self._mission or checkpoint._seed != self.seed:
            raise Error("the checkpoint is of another mission or seed")
        self._core.restore(checkpoint._core)

    def end_recording(self) -> None:
        """Closes the file that the run is recorded in, which says then how it ended; else that is so once the
        run is forgotten."""
        self._core.end_recording()

    def __repr__(self) -> str:
        """Which mission, and how far it is."""
        return f"<run of {self._mission.name!r}, seed {self.seed}, at {self.time:.1f} s: {self.outcome}>"


def _number(robot: int | Robot) -> int:
    return robot.number if isinstance(robot, Robot) else whole(robot, "robot", 0, 2**32 - 1)


def _port(name: object, what: str = "port") -> str:
    return text_of(name, what, "the name of a port")


class Mission(NotPickled):
    """A mission that was read and checked; :func:`mlab.load` makes one. It never changes.

    Its files were read when it was loaded: all runs are of the same texts, whatever happens to the files.
    """

    _why = "its programs are built in this process; load it where it is needed"

    def __init__(self, core: object) -> None:
        """Made by :func:`mlab.load`."""
        self._core = core

    @property
    def name(self) -> str:
        """As the mission calls itself."""
        return self._core.name

    @property
    def path(self) -> str:
        """The file that it was read from."""
        return self._core.path

    @property
    def warnings(self) -> tuple[Problem, ...]:
        """What is odd in it."""
        return problems_of(self._core.warnings)

    @property
    def robots(self) -> dict[int, str]:
        """The type of each robot, by its number."""
        return dict(self._core.robots)

    def ports(self, type: str = "ROBOT") -> dict[str, Port]:
        """The ports of a robot type's program, by name; none where nothing here answers to the program's name.

        Ports of a program that runs in an executable of its own are not known.
        """
        return _ports(self._core.describe(text_of(type, "type", "the name of a robot type")))

    def run(
        self,
        seed: int = 1,
        *,
        threads: int = 1,
        proceed: bool = True,
        patience: float = 600.0,
        start_time: str = "",
        record: str | os.PathLike | None = None,
    ) -> Run:
        """A new run, at its beginning: the mission has begun, no time has passed.

        seed: of all chances. The same seed gives the same run.
        threads: how many compute it; the result is the same.
        proceed: questions to the operator answer themselves with yes, as ``mlab run --proceed``.
        patience: simulated seconds without progress after which a command has failed.
        start_time: what the mission's clock shows at the start, ``YYYY-MM-DD HH:MM[:SS]``; empty: now.
        record: a new file in which the run is recorded, for ``mlab replay`` and ``mlab trace``.
        """
        if record is not None and os.path.exists(path_of(record, "record")):
            raise Error(f"record {os.fspath(record)}: there is such a file already, and a recording is never written over")
        core = self._core.make_run(
            whole(seed, "seed"),
            whole(threads, "threads", 1, 256),
            bool(proceed),
            positive(patience, "patience"),
            text_of(start_time, "start_time", "a time"),
            "" if record is None else path_of(record, "record"),
        )
        return Run(core, self)

    def __repr__(self) -> str:
        """What it is called, and how many robots it has."""
        return f"<mission {self.name!r} with {len(self.robots)} robots, from {self.path}>"


def load(
    path: str | os.PathLike,
    *,
    set: Mapping[str, object] | None = None,
    environment: str | os.PathLike | None = None,
    allow_native: bool = False,
    cell: bool = True,
) -> Mission:
    """Reads a mission, and all that it names; its robots' programs are built.

    path: of the mission, an ``.mdl`` file.
    set: values in place of what the mission says, as ``--set`` of ``mlab run``: ``{"base_velocity": 2}``,
        ``{"scout:base_velocity": 2, "OBSTACLE-COVERAGE": 5}``.
    environment: a file that says what changes in the world while the mission runs.
    allow_native: executables that the mission names are started. Whoever wrote them can do what you can.
    cell: procedures in C++ that the mission brings are compiled, and run in a cell, where they reach neither
        files nor network. Without it they run as any program does, outside of this process.

    Raises :class:`Error` with everything that is wrong, each at its place. What is only odd is warned of as
    :class:`MissionWarning`.
    """
    if set is not None and not isinstance(set, Mapping):
        raise TypeError(f"set: expected names with their values, {{'base_velocity': 2}}, not {type(set).__name__}")
    given = [(str(name), written(value, str(name))) for name, value in (set or {}).items()]
    file = "" if environment is None else path_of(environment, "environment")
    out = Mission(_core.load(path_of(path, "path"), given, file, bool(allow_native), bool(cell)))
    for problem in out.warnings:
        if problem.severity == "warning":
            warnings.warn(problem.text.rstrip(), MissionWarning, stacklevel=2)
    return out


def missions() -> Iterator[str]:
    """The missions that come with missionlab, as paths for :func:`load`."""
    for folder in (
        os.path.join(_core.prefix, "share", "mlab", "missions"),
        os.path.join(_core.source, "missions"),
    ):
        if os.path.isdir(folder):
            for root, _, files in sorted(os.walk(folder)):
                yield from (os.path.join(root, name) for name in sorted(files) if name.endswith(".mdl"))
            return
