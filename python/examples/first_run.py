"""A mission, step by step: where its robots are, what they compute, how it ends.

    ./mlab python python/examples/first_run.py
"""

import numpy as np

import mlab

mission = mlab.load("missions/patrol/patrol.mdl")
run = mission.run(seed=3)
print(mission.name, "has the robots", list(mission.robots))

run.step(100)  # cycles of 0.1 s
for robot in run.robots:
    x, y, heading = robot.pose
    print(f"after {run.time:.0f} s robot {robot.number} is at {x:.0f}, {y:.0f}")

# What any port of its program holds, as `mlab describe` calls it.
print("base velocity:", run.port(1, "base_velocity"), run.robots[0].ports["base_velocity"].unit)

# The first robot goes slower from now on; nothing else changes.
run.set(1, "base_velocity", 0.5)
table = run.trace(["base_velocity"], robots=1)
way = np.hypot(np.diff(table["x"]), np.diff(table["y"]))
print(f"it made {way.sum():.0f} m more in {table['time'][-1] - table['time'][0]:.0f} s")
print("outcome:", run.outcome)

# It prints:
#     Patrol has the robots [1, 2]
#     after 10 s robot 1 is at 120, 162
#     after 10 s robot 2 is at 83, 173
#     base velocity: 5.0 m/s
#     it made 508 m more in 1108 s
#     outcome: done
