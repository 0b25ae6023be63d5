"""Missions of teams of robots, from Python: read, run, look into, repeat, and learn in.

Load a mission, and let it run::

    import mlab

    mission = mlab.load("missions/demo_c/demo_c.mdl")
    run = mission.run(seed=3)
    run.step(100)                         # ten simulated seconds
    print(run.robots[0].pose)             # [x, y, heading]: m, m, rad
    print(run.port(1, "*.gain"))          # what ports of robot 1 hold
    print(run.finish())                   # done

Many times, as columns of numpy::

    table = mlab.batch("missions/demo_c/demo_c.mdl", runs=100, set={"base_velocity": [1, 2, 5]})
    print(table["duration_s"].mean(), table.combinations)
    frame = table.to_pandas()

For learning, with Gymnasium's interface::

    environment = mlab.Environment(mlab.Scenario(robots=1000), observation="body.ranges", action="wish")
    observation, info = environment.reset(seed=1)

Units are SI: metres, seconds, radians, m/s. The world: x east, y north, angles counter-clockwise from east. A
robot: x ahead, y left. Arrays are of float64, and copies: nothing changes in them behind your back.

What can't be used raises :class:`Error`, a ValueError that knows file, line and column of each problem.
``docs/python.md`` teaches all of it.
"""

from . import _core
from ._batch import Batch, Combination, batch
from ._environment import Column, Environment, Scenario, Space
from ._errors import Error, MissionWarning, Problem
from ._mission import Checkpoint, Mission, Port, Robot, Run, load, missions
from ._table import Table

__version__ = _core.version

__all__ = [
    "Batch",
    "Checkpoint",
    "Column",
    "Combination",
    "Environment",
    "Error",
    "Mission",
    "MissionWarning",
    "Port",
    "Problem",
    "Robot",
    "Run",
    "Scenario",
    "Space",
    "Table",
    "batch",
    "load",
    "missions",
]
