"""Robots that learn: stepped by one array, seen through another."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from . import _core
from ._errors import Error
from ._mission import Mission, load
from ._values import NotPickled, names_of, path_of, positive, whole


class Column(NamedTuple):
    """A column of an environment's arrays: one number of each robot."""

    name: str
    """``base_velocity``, ``goal.x``, ``body.ranges.3``"""
    unit: str
    """SI; angles are in radians; empty: none."""
    help: str
    """What it tells or sets."""
    low: float
    """The least that it takes, or can be; ``-inf``: no limit."""
    high: float
    """The most."""


class Space(NotPickled):
    """Which arrays there can be. Has what libraries for learning ask of a ``Box`` of Gymnasium's, without needing
    it: ``shape``, ``dtype``, ``low``, ``high``, ``sample``, ``contains``."""

    _why = "it has a generator of chances; make it anew"

    def __init__(self, columns: Sequence[Column], robots: int) -> None:
        """Arrays with a row for each robot and these columns."""
        self.columns = tuple(columns)
        """What each column is."""
        self.shape = (robots, len(self.columns))
        """(robots, columns)"""
        self.dtype = np.dtype(np.float64)
        """Of the arrays."""
        self.low = np.broadcast_to(np.array([one.low for one in self.columns], dtype=float), self.shape)
        """The least of each number; may not be written to."""
        self.high = np.broadcast_to(np.array([one.high for one in self.columns], dtype=float), self.shape)
        """The most of each number; may not be written to."""
        self._random = np.random.default_rng(0)

    def seed(self, seed: int | None = None) -> None:
        """What :meth:`sample` draws follows from the seed; None: from one that nobody knows."""
        self._random = np.random.default_rng(seed)

    def sample(self) -> np.ndarray:
        """An array drawn from the space: evenly between limits; where there is none, about zero or the limit."""
        bounded = np.isfinite(self.low) & np.isfinite(self.high) & (self.high - self.low < 1e6)
        low = np.where(bounded, self.low, np.maximum(self.low, -1.0))
        high = np.where(bounded, self.high, np.minimum(self.high, np.maximum(low + 1.0, 1.0)))
        return self._random.uniform(low, np.maximum(low, high))

    def contains(self, array: object) -> bool:
        """Whether an array is one of these."""
        values = np.asarray(array)
        if values.shape != self.shape or values.dtype.kind not in "fiub":
            return False
        return bool(np.all((values >= self.low) & (values <= self.high)))

    __contains__ = contains

    def __repr__(self) -> str:
        """Its shape, and what the columns are called."""
        return f"<space of {self.shape}: {', '.join(one.name for one in self.columns)}>"


class Scenario(NamedTuple):
    """The scenario of ``mlab bench``, for an :class:`Environment`: a square arena with 10 m² for each robot, walls
    round it, discs over 5 per cent of it, and robots with differential drive and 24 range sensors."""

    robots: int = 1000
    """How many; from 1 to 1,000,000."""
    control: str | os.PathLike = "steered"
    """The program of the robots: ``steered`` goes as its parameter ``wish`` says (x: ahead [m/s], z: turning
    [rad/s]), ``schemas`` and ``diffusion`` are those of ``mlab bench``; or a file, a network in CNL of
    procedures of the library."""
    places: int = 1
    """Seed of where robots and discs are."""
    range: float = 1.0
    """Of the range sensors [m]."""
    cycle_duration: float = 0.1
    """[s]"""


class Environment(NotPickled):
    """Robots of a mission, or of a scenario, for learning: Gymnasium's interface, without needing it.

    All robots are stepped at once: arrays have a row for each robot and a column for each number, of float64. An
    action goes in as parameters of the robots' programs (or as outputs that are held), an observation comes out
    of their ports, or of their bodies::

        environment = mlab.Environment(mlab.Scenario(robots=100), observation="body.ranges", action="wish")
        observation, info = environment.reset(seed=1)
        action = np.zeros(environment.action_space.shape)
        observation, reward, terminated, truncated, info = environment.step(action)

    In a step every robot senses, its program computes with the action, and the robot moves; what is seen of
    programs is what they computed in this cycle, of bodies how they stand after it. The same seed and the same
    actions give the same observations, bit for bit, for any number of threads. Arrays are copies.

    An environment serves one thread at a time, and only the process that made it.
    """

    _why = "it is computed in this process; make it where it is needed"

    metadata = {"render_modes": []}
    """As Gymnasium has it; nothing is drawn."""
    render_mode = None
    """Likewise."""

    def __init__(
        self,
        world: Mission | Scenario | str | os.PathLike,
        *,
        observation: str | Sequence[str],
        action: str | Sequence[str],
        reward: str | Callable[[np.ndarray, np.ndarray, np.ndarray], object] | None = None,
        robots: Sequence[int] = (),
        limit: float | None = None,
        threads: int = 1,
        patience: float = 600.0,
    ) -> None:
        """Makes an environment; :meth:`reset` begins.

        world: a mission, the path of one, or a :class:`Scenario`.
        observation: names of ports, in which ``*`` stands for any characters, and of bodies: ``body.pose`` is
            ``body.x``, ``body.y`` [m], ``body.heading`` [rad]; ``body.contacts``; ``body.driven`` [m];
            ``body.ranges`` [m], a column for each beam. A vector is ``PORT.x``, ``PORT.y``, ``PORT.z``; one of
            them may be named alone.
        action: names of parameters and constants; in missions also of outputs, which then are held.
        reward: a port of one column; or a function of observation, action and next observation that gives a
            number for each robot; None: rewards are 0.
        robots: numbers of the mission's robots that learn, a row for each; none: all. The others go on by
            themselves.
        limit: simulated seconds after which an episode is truncated.
        threads: how many compute it; the result is the same.
        patience: of a mission: simulated seconds without progress after which a command has failed.
        """
        seen, acted = names_of(observation, "observation"), names_of(action, "action")
        self._reward_by = reward
        self._has_reward_column = isinstance(reward, str)
        if isinstance(reward, str):
            seen = [*seen, reward]  # one column more, behind those that are asked for
        elif reward is not None and not callable(reward):
            raise TypeError("reward: expected the name of a port, or a function of observation, action and next observation")
        self._limit = None if limit is None else positive(limit, "limit")
        threads = whole(threads, "threads", 1, 256)
        if isinstance(world, Scenario):
            if robots:
                raise Error("robots: all robots of a scenario learn")
            self._core = _core.scenario_stage(
                path_of(world.control, "control"),
                whole(world.robots, "robots", 1, 1_000_000),
                whole(world.places, "places"),
                min(positive(world.range, "range"), 1000.0),
                positive(world.cycle_duration, "cycle_duration"),
                threads,
                seen,
                acted,
            )
        else:
            mission = world if isinstance(world, Mission) else load(world)
            numbers = [whole(one, "robots", 0, 2**32 - 1) for one in robots]
            self._core = _core.mission_stage(
                mission._core, threads, positive(patience, "patience"), numbers, seen, acted
            )
        self._finish_columns()
        self._observation = None
        self._seed = 0

    def _finish_columns(self) -> None:
        seen = [Column(**one) for one in self._core.seen()]
        if self._has_reward_column:
            if seen[-1].name != self._reward_by:
                raise Error(f"reward: `{self._reward_by}` is not one number; expected one, such as `{seen[-1].name}`")
            seen = seen[:-1]
        self._robots = tuple(self._core.robots())
        self.observation_space = Space(seen, len(self._robots))
        """Which observations there can be: a :class:`Space`."""
        self.action_space = Space([Column(**one) for one in self._core.acted()], len(self._robots))
        """Which actions are taken: a :class:`Space`."""

    @property
    def robots(self) -> tuple[int, ...]:
        """The numbers of the robots, by row of the arrays."""
        return self._robots

    @property
    def num_envs(self) -> int:
        """How many robots there are, as Gymnasium's vector environments call it."""
        return len(self._robots)

    @property
    def time(self) -> float:
        """Simulated time since the last reset [s]."""
        return self._core.time()

    def reset(self, *, seed: int | None = None, options: Mapping[str, object] | None = None) -> tuple[np.ndarray, dict]:
        """Everything begins anew.

        seed: of all chances; None: the next one after the last, the first time 1.
        options: there are none; as Gymnasium has it.

        Returns the observation, and a dictionary with ``time`` [s], ``cycle`` and ``seed``. Before the first cycle
        programs have computed nothing: their outputs are zero. Bodies are there already.
        """
        if options:
            raise Error(f"options: there are none, found {', '.join(map(str, options))}")
        self._seed = self._seed + 1 if seed is None else whole(seed, "seed")
        self._observation = None
        self._core.reset(self._seed)
        observation, _ = self._parted(self._core.observe())
        self._keep(observation)
        return observation, {**self._info(), "seed": self._seed}

    def step(self, action: object) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, dict]:
        """One control cycle.

        action: an array of the shape of :attr:`action_space`. A number that its parameter does not take raises
            :class:`Error`, which says which one, and nothing has happened.

        Returns the observation; the reward of each robot; for each whether its episode is terminated (the mission
        is over, or the robot stopped or faulted); for each whether it is truncated (``limit`` is reached); and a
        dictionary with ``time`` [s] and ``cycle``.
        """
        if self._observation is None:
            raise Error("step: nothing has begun; expected reset() first")
        actions = np.ascontiguousarray(action, dtype=np.float64)
        seen, reward = self._parted(self._core.step(actions))
        before = self._observation
        self._keep(seen)
        robots = len(self._robots)
        if reward is None and self._reward_by is not None:
            reward = self._given(self._reward_by(before, actions, seen))
        elif reward is None:
            reward = np.zeros(robots)
        is_late = self._limit is not None and self.time >= self._limit - 1e-9
        terminated = self._core.ended()
        return seen, reward, terminated, np.full(robots, is_late) & ~terminated, self._info()

    def close(self) -> None:
        """Ends it; there is nothing left behind. As Gymnasium has it."""
        self._observation = None

    def _given(self, reward: object) -> np.ndarray:
        try:
            return np.broadcast_to(np.asarray(reward).astype(np.float64, casting="same_kind"), len(self._robots)).copy()
        except (TypeError, ValueError):
            raise Error(
                f"reward: the function gave {type(reward).__name__} of the shape {np.shape(reward)}; "
                f"expected a number for each of {len(self._robots)} robots"
            ) from None

    def _keep(self, observation: np.ndarray) -> None:
        # What was handed out is its owner's, who may write to it; only a function of rewards looks back.
        self._observation = observation.copy() if callable(self._reward_by) else True

    def _info(self) -> dict:
        return {"time": self._core.time(), "cycle": self._core.cycle()}

    def _parted(self, seen: np.ndarray) -> tuple[np.ndarray, np.ndarray | None]:
        if not self._has_reward_column:
            return seen, None
        return np.ascontiguousarray(seen[:, :-1]), seen[:, -1].copy()

    def __repr__(self) -> str:
        """How many robots, how they are seen and steered."""
        return f"<environment of {len(self._robots)} robots, observation {self.observation_space.shape}, action {self.action_space.shape}>"
